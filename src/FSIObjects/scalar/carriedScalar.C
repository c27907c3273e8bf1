// SPDX-License-Identifier: GPL-3.0-or-later

#include "carriedScalar.H"
#include "dictionaryCheck.H"
#include "errorOf.H"
#include "fsiObjects.H"
#include "objectWriter.H"
#include "openVolume.H"
#include "openfoamMesh.H"
#include "sumOverRanks.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- Open part of a cell from the distances at its corners
static scalar openPart
(
    const cartesianBlock& corners,
    const scalarField& distance,
    const labelVector& ijk
)
{
    // Around the lower face, and above
    static const label x[] = {0, 1, 1, 0};
    static const label y[] = {0, 0, 1, 1};
    FixedList<scalar, 8> values;
    for (label i = 0; i < (corners.nDims() == 2 ? 4 : 8); ++i)
    {
        const labelVector corner(x[i % 4], y[i % 4], i/4);
        values[i] = distance[corners.index(ijk + corner)];
    }
    return
        corners.nDims() == 2
      ? openSquare({values[0], values[1], values[2], values[3]})
      : openCube(values);
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::tmp<Foam::scalarField> Foam::fsi::carriedScalar::openVolumes() const
{
    const cartesianMesh& grid = objects_.grid();
    const cartesianBlock cells(grid.cells());
    const cartesianBlock corners(grid.corners());
    const scalarField& distance = objects_.levelSet().cellDistance();
    const scalarField& atCorners = objects_.levelSet().cornerDistance();
    const scalar whole = grid.faceArea()*grid.spacing();
    auto topen = newTmp<scalarField>(C_.size());
    scalarField& open = topen.ref();
    forAll(open, celli)
    {
        const scalar away = distance[grid.haloIndex()[celli]];
        const bool full =
            surfaces_.fixed()[celli]
         || surfaces_.beside()[celli]
         || away > grid.spacing();
        open[celli] =
            full ? 1
          : !geometry_.activeCell()[celli] ? 0
          : openPart(corners, atCorners, cells.ijk(grid.blockIndex()[celli]));
    }
    open *= whole;
    return topen;
}


void Foam::fsi::carriedScalar::setFixed()
{
    forAll(C_, celli)
    {
        if (surfaces_.fixed()[celli])
        {
            C_[celli] = surfaces_.value(celli);
        }
    }
    C_.correctBoundaryConditions();
}


void Foam::fsi::carriedScalar::countFixed(const scalarField& taken)
{
    for (const fixedLink& link : links_)
    {
        fromSurfaces_[surfaces_.group()[link.cell]] +=
            link.ofFixed*link.value - link.ofCell*C_[link.cell];
    }
    const scalar perStep = 1/objects_.deltaT();
    forAll(taken, celli)
    {
        if (surfaces_.beside()[celli])
        {
            fromSurfaces_[surfaces_.group()[celli]] +=
                perStep*taken[celli]*C_[celli];
        }
    }
}


Foam::scalar Foam::fsi::carriedScalar::inflow
(
    const fvScalarMatrix& equation
) const
{
    scalar sum = 0;
    forAll(C_.boundaryField(), patchi)
    {
        const fvPatchScalarField& pC = C_.boundaryField()[patchi];
        const labelUList& cells = pC.patch().faceCells();
        for (label i = 0; i < pC.size() && !pC.coupled(); ++i)
        {
            sum +=
                boundaryCoeffsOf(equation)[patchi][i]
              - internalCoeffsOf(equation)[patchi][i]*C_[cells[i]];
        }
    }
    return sum;
}


void Foam::fsi::carriedScalar::spread(const fvScalarMatrix& equation)
{
    // Sum of the residuals of all cells that are not fixed, which have no
    // coefficients of fixed ones; their volume
    const boolList& fixed = surfaces_.fixed();
    scalarList sums({0, 0, 0});
    forAll(fixed, celli)
    {
        if (!fixed[celli])
        {
            sums[2] += mag(equation.source()[celli]);
            sums[0] +=
                equation.source()[celli] - equation.diag()[celli]*C_[celli];
            sums[1] += volumes_.now()[celli];
        }
    }
    const labelUList& own = C_.mesh().owner();
    const labelUList& nei = C_.mesh().neighbour();
    forAll(own, facei)
    {
        sums[0] -=
            equation.upper()[facei]*C_[nei[facei]]
          + equation.lower()[facei]*C_[own[facei]];
    }
    forAll(C_.boundaryField(), patchi)
    {
        const fvPatchScalarField& pC = C_.boundaryField()[patchi];
        const scalarField& ofOther = boundaryCoeffsOf(equation)[patchi];
        const scalarField& ofCell = internalCoeffsOf(equation)[patchi];
        scalarField across(pC.size(), scalar(1));
        if (pC.coupled())
        {
            across = pC.patchNeighbourField();
        }
        sums[0] += sum(ofOther*across - ofCell*pC.patchInternalField());
    }
    sumOverRanks(sums);
    if (mag(sums[0]) <= 10*SMALL*sums[2])
    {
        // The sum's own round-off
        return;
    }
    const scalar shift = objects_.deltaT()*sums[0]/max(sums[1], VSMALL);
    forAll(fixed, celli)
    {
        C_[celli] += fixed[celli] ? 0 : shift;
    }
}


void Foam::fsi::carriedScalar::write(const scalar inflow)
{
    scalar least = GREAT;
    scalar largest = -GREAT;
    scalarList sums(2 + fromSurfaces_.size(), Zero);
    sums[0] = 0;
    sums[1] = inflow;
    forAll(fromSurfaces_, groupi)
    {
        sums[2 + groupi] = fromSurfaces_[groupi];
    }
    forAll(C_, celli)
    {
        if (!surfaces_.fixed()[celli])
        {
            sums[0] += volumes_.now()[celli]*C_[celli];
        }
        if (geometry_.fluidCell()[celli])
        {
            least = min(least, C_[celli]);
            largest = max(largest, C_[celli]);
        }
    }
    sumOverRanks(sums);
    least = overRanks(least, minOp<scalar>());
    largest = overRanks(largest, maxOp<scalar>());
    if (table_.valid())
    {
        csvTable::rowWriter row(table_());
        row << C_.mesh().time().value() << sums[0] << least << largest;
        for (label i = 1; i < sums.size(); ++i)
        {
            row << sums[i];
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::carriedScalar::carriedScalar
(
    const fsiObjects& objects,
    const interfaceGeometry& geometry,
    const word& name,
    const dictionary& dict
)
:
    objects_(objects),
    geometry_(geometry),
    C_
    (
        IOobject
        (
            name,
            nameOf(objects.grid().mesh().time()),
            objects.grid().mesh(),
            IOobject::MUST_READ,
            IOobject::AUTO_WRITE
        ),
        objects.grid().mesh()
    ),
    diffusivity_(readPositive(dict, "diffusivity")),
    surfaces_(objects, geometry, dict.subOrEmptyDict("surfaces")),
    volumes_(objects.grid(), name + "Volume", openVolumes()()),
    fromSurfaces_(surfaces_.all().size(), Zero),
    expansion_(0),
    reference_(0)
{
    checkKeys(dict, {"diffusivity", "surfaces", "buoyancy"});
    checkSubDicts(dict, {"surfaces", "buoyancy"});
    if (dict.found("buoyancy"))
    {
        const dictionary& buoyancy = dict.subDict("buoyancy");
        checkKeys(buoyancy, {"expansion", "reference"});
        expansion_ = readEntry<scalar>(buoyancy, "expansion");
        reference_ = readEntryOr<scalar>(buoyancy, "reference", 0);
    }
    wordList columns({"time", "amount", "least", "largest", "inflow"});
    for (const bodyGroup& group : objects.bodies().groups())
    {
        columns.append(group.shape().name());
    }
    table_ =
        objectWriter::newTable(objects.grid().mesh().time(), name, columns);
    setFixed();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::carriedScalar::addBuoyancy(vectorField& source) const
{
    if (expansion_ == 0)
    {
        return;
    }
    const scalar whole = objects_.grid().faceArea()*objects_.grid().spacing();
    const vector perDifference(-whole*expansion_*objects_.gravity());
    forAll(source, celli)
    {
        if (geometry_.fluidCell()[celli])
        {
            source[celli] += (C_[celli] - reference_)*perDifference;
        }
    }
}



void Foam::fsi::carriedScalar::advance(const surfaceScalarField& phi)
{
    const scalar perStep = 1/objects_.deltaT();
    const boolList wasFixed(surfaces_.fixed());
    const scalarField last(C_.primitiveField());
    surfaces_.update();
    setFixed();

    surfaceScalarField flux(C_.name() + "Flux", phi);
    boolList free(C_.size());
    forAll(free, celli)
    {
        free[celli] = surfaces_.fixed()[celli] || surfaces_.beside()[celli];
    }
    const tmp<scalarField> ttaken
    (
        volumes_.advance(openVolumes(), openFaces(), free, flux)
    );
    const scalarField& taken = ttaken();

    fvScalarMatrix equation(C_, C_.dimensions()*dimVolume/dimTime);
    addTransport(flux, equation);
    fromSurfaces_ = Zero;
    addSurfaces(equation);
    forAll(taken, celli)
    {
        const scalar before = perStep*volumes_.last()[celli]*last[celli];
        equation.diag()[celli] +=
            perStep*(volumes_.now()[celli] - taken[celli]);
        equation.source()[celli] += before;
        const bool fixed = surfaces_.fixed()[celli];
        if (fixed != wasFixed[celli])
        {
            fromSurfaces_[surfaces_.group()[celli]] += fixed ? -before : before;
        }
    }
    fixCells(equation);
    equation.solve(solverControls(C_.mesh(), C_.name()));
    countFixed(taken);
    const scalar in = inflow(equation);
    spread(equation);
    C_.correctBoundaryConditions();
    write(in);
}


// ************************************************************************* //
