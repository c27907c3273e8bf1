// SPDX-License-Identifier: GPL-3.0-or-later

#include "cartesianMultigrid.H"
#include "latticeRanks.H"
#include "stencilProducts.H"
#include "stencilSetup.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::fsi::multigridHierarchy::controls Foam::fsi::cartesianMultigrid::read
(
    const dictionary& controls
)
{
    multigridHierarchy::controls result;
    const auto readCells = [&](const word& key, label& cells)
    {
        cells = controls.lookupOrDefault<label>(key, cells);
        if (cells < 1)
        {
            FatalIOErrorInFunction(controls)
                << "Entry '" << key << "' " << cells
                << " in dictionary " << controls.name() << " must be >= 1"
                << exit(FatalIOError);
        }
    };
    readCells("wCycleCells", result.wCycleCells);
    readCells("gatherCells", result.gatherCells);
    return result;
}


Foam::vector Foam::fsi::cartesianMultigrid::weights
(
    const cartesianLattice& lattice
)
{
    vector result;
    for (direction d = 0; d < 3; ++d)
    {
        result[d] = 1/sqr(lattice.map().spacing()[d]);
    }
    return result;
}


Foam::scalar Foam::fsi::cartesianMultigrid::total(scalar value) const
{
    reduceOverRanks(value, sumOp<scalar>(), lattice_.comm());
    return value;
}


void Foam::fsi::cartesianMultigrid::setFinest(const scalarField& added)
{
    const stencil<double>& A = matrix_.A();
    norm_ = 0;
    for (label r = 0; r < A.ny*A.nz; ++r)
    {
        const label row = A.row(r);
        for (label place = row; place < row + A.nx; ++place)
        {
            norm_ = max(norm_, A.diagonal[place]);
        }
    }
    reduceOverRanks(norm_, maxOp<scalar>(), lattice_.comm());
    norm_ = norm_ > 0 ? norm_ : 1;

    multigridLevel& finest = hierarchy_.finest();
    for (direction d = 0; d < (A.threeD ? 3 : 2); ++d)
    {
        scaled(A, 1/norm_, A.face[d], finest.face(d).data());
    }
    setExcess
    (
        A, 1/norm_, matrix_.rowSum().cdata(), added.cdata(),
        finest.excess().data()
    );
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::cartesianMultigrid::cartesianMultigrid
(
    const polyMesh& mesh,
    const dictionary& controls
)
:
    lattice_(cartesianLattice::New(mesh)),
    matrix_(lattice_),
    sum_(matrix_),
    hierarchy_
    (
        lattice_.partition(),
        weights(lattice_),
        read(controls),
        lattice_.comm()
    ),
    nMeshCells_(total(scalar(mesh.nCells()))),
    norm_(1)
{
    for (scalarField* field : {&x_, &r_, &p_, &Ap_})
    {
        field->setSize(lattice_.layout().size(), 0);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::cartesianMultigrid::update
(
    const lduMatrix& matrix,
    const FieldField<Field, scalar>& interfaceBouCoeffs,
    const lduInterfaceFieldPtrsList& interfaces,
    const scalarField& addedDiagonal
)
{
    matrix_.update(matrix, interfaceBouCoeffs, interfaces);

    bool adds = addedDiagonal.size() > 0;
    reduceOverRanks(adds, orOp<bool>(), lattice_.comm());

    // Ap_ is free between two solutions
    Ap_ = 0;
    if (adds)
    {
        lattice_.transfer().toBlock
        (
            addedDiagonal, matrix_.sign(), Ap_.data()
        );
    }
    setFinest(Ap_);
    hierarchy_.update();
}


void Foam::fsi::cartesianMultigrid::precondition
(
    scalarField& z,
    const scalarField& r,
    const bool smooths
) const
{
    // Single precision needs values of order one
    const scalar size = max(total(sumMag(r))/nMeshCells_, VSMALL);

    multigridLevel& finest = hierarchy_.finest();
    lattice_.transfer().toBlock(r, 1/size, finest.b().data());
    if (smooths)
    {
        hierarchy_.cycle();
    }
    else
    {
        hierarchy_.cycleCoarse();
    }
    lattice_.transfer().toCells
    (
        finest.x().cdata(), matrix_.sign()*size/norm_, z
    );
}


// ************************************************************************* //
