// SPDX-License-Identifier: GPL-3.0-or-later

#include "structuredMatrix.H"
#include "latticeRanks.H"
#include "solverPerformance.H"
#include "stencilSetup.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::label Foam::fsi::structuredMatrix::target(const label celli) const
{
    return
        lattice_.transfer().local()
      ? lattice_.layout().globalIndex(lattice_.map().cells()[celli])
      : celli;
}


template<class Face>
void Foam::fsi::structuredMatrix::setInternal
(
    const scalarField& upper,
    const label n,
    const Face& face
)
{
    const bool local = lattice_.transfer().local();
    const List<direction>& dir = lattice_.map().faceDirection();
    double* to[3];
    for (direction d = 0; d < 3; ++d)
    {
        to[d] = local ? face_[d].data() : cellFace_[d].data();
    }
    for (label i = 0; i < n; ++i)
    {
        const label facei = face(i);
        to[dir[facei]][target_[facei]] = -sign_*upper[facei];
    }
}


void Foam::fsi::structuredMatrix::setPatch
(
    const label patchi,
    const scalarField& coefficients,
    scalarField& diagonal
)
{
    const labelList& cells = lattice_.map().patchCell()[patchi];
    const List<direction>& dir = lattice_.map().patchDirection()[patchi];
    if (cells.size() != coefficients.size())
    {
        FatalErrorInFunction
            << "Patch " << lattice_.map().mesh().boundaryMesh()[patchi].name()
            << " couples cells but is not a processor or cyclic patch. "
            << "Use GAMG for this equation." << exit(FatalError);
    }
    const bool local = lattice_.transfer().local();
    forAll(cells, i)
    {
        const label celli = cells[i];
        if (celli >= 0)
        {
            const scalar a = sign_*coefficients[i];
            const direction d = dir[i];
            if (lattice_.map().n()[d] == 1)
            {
                // From both sides
                diagonal[celli] -= 2*a;
            }
            else if (local)
            {
                face_[d][target(celli)] = a;
            }
            else
            {
                cellFace_[d][celli] = a;
            }
        }
    }
}


void Foam::fsi::structuredMatrix::setRows
(
    const lduMatrix& matrix,
    const FieldField<Field, scalar>& interfaceBouCoeffs,
    const lduInterfaceFieldPtrsList& interfaces
)
{
    scalarField diagonal(sign_*matrix.diag());
    forAll(interfaces, patchi)
    {
        if (interfaces.set(patchi))
        {
            setPatch(patchi, interfaceBouCoeffs[patchi], diagonal);
        }
    }

    const cellTransfer& transfer = lattice_.transfer();
    transfer.toBlock(diagonal, 1, diagonal_.data());
    for (direction d = 0; d < nDirections(); ++d)
    {
        if (!transfer.local())
        {
            transfer.toBlock(cellFace_[d], 1, face_[d].data());
        }
        halo_.fillHigh(d, face_[d].data());
    }
    rowSums(A_, rowSum_.data());

    singular_ = true;
    forRows([&](const label place)
    {
        // Up to rounding
        singular_ =
            singular_
         && mag(rowSum_[place]) <= 1e-12*A_.diagonal[place];
    });
    reduceOverRanks(singular_, andOp<bool>(), lattice_.comm());
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::structuredMatrix::structuredMatrix(const cartesianLattice& lattice)
:
    lattice_(lattice),
    halo_(lattice.layout(), lattice.comm()),
    target_(lattice.map().faceCell().size()),
    diagonal_(lattice.layout().size(), Zero),
    rowSum_(lattice.layout().size(), Zero),
    A_(lattice.layout()),
    sign_(1),
    singular_(false)
{
    forAll(target_, facei)
    {
        target_[facei] = target(lattice.map().faceCell()[facei]);
    }
    for (label d = 0; d < nDirections(); ++d)
    {
        face_[d].setSize(lattice.layout().size(), 0);
        if (!lattice.transfer().local())
        {
            cellFace_[d].setSize(lattice.map().cells().size(), 0);
        }
    }
    for (label d = 0; d < 3; ++d)
    {
        // Without a third direction its pointer is valid but not used
        A_.face[d] = face_[d < nDirections() ? d : 0].cdata();
    }
    A_.diagonal = diagonal_.cdata();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::fsi::structuredMatrix::normFactor
(
    const scalarField& Ax,
    const scalarField& source,
    const scalar average
) const
{
    scalar total = 0;
    forRows([&](const label place)
    {
        const scalar reference = rowSum_[place]*average;
        total += mag(Ax[place] - reference) + mag(source[place] - reference);
    });
    reduceOverRanks(total, sumOp<scalar>(), lattice_.comm());
    return total + solverPerformance::small_;
}


void Foam::fsi::structuredMatrix::update
(
    const lduMatrix& matrix,
    const FieldField<Field, scalar>& interfaceBouCoeffs,
    const lduInterfaceFieldPtrsList& interfaces
)
{
    scalar total = sum(matrix.diag());
    reduceOverRanks(total, sumOp<scalar>(), lattice_.comm());
    sign_ = total < 0 ? -1 : 1;
    if (matrix.hasUpper())
    {
        const scalarField& upper = matrix.upper();
        setInternal(upper, upper.size(), [](const label i) { return i; });
    }
    setRows(matrix, interfaceBouCoeffs, interfaces);
}


void Foam::fsi::structuredMatrix::change
(
    const lduMatrix& matrix,
    const FieldField<Field, scalar>& interfaceBouCoeffs,
    const lduInterfaceFieldPtrsList& interfaces,
    const labelUList& faces
)
{
    const auto face = [&](const label i) { return faces[i]; };
    setInternal(matrix.upper(), faces.size(), face);
    setRows(matrix, interfaceBouCoeffs, interfaces);
}


void Foam::fsi::structuredMatrix::removeLevel(scalarField& source) const
{
    if (!singular_)
    {
        return;
    }
    scalar sums[2] = {0, 0};
    forRows([&](const label place)
    {
        sums[0] += A_.diagonal[place] != 0 ? source[place] : 0;
        sums[1] += A_.diagonal[place] != 0;
    });
    for (scalar& sum : sums)
    {
        reduceOverRanks(sum, sumOp<scalar>(), lattice_.comm());
    }
    const scalar mean = sums[0]/max(sums[1], 1);
    forRows([&](const label place)
    {
        source[place] -= A_.diagonal[place] != 0 ? mean : 0;
    });
}


// ************************************************************************* //
