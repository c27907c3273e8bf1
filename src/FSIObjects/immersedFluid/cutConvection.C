// SPDX-License-Identifier: GPL-3.0-or-later

#include "cutConvection.H"
#include "levelSetUpdate.H"
#include "objectMeans.H"
#include "swapCoupledCells.H"
#include "vectorList.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::cutConvection::set
(
    const surfaceScalarField& flux,
    fluxes& values
) const
{
    const polyBoundaryMesh& patches = flux.mesh().boundaryMesh();
    const UList<wallLink>& links = geometry_.wallLinks();
    values.links.setSize(links.size());
    forAll(links, i)
    {
        const wallLink& link = links[i];
        if (link.across >= 0)
        {
            // The owner is the cell of the lower number
            values.links[i] =
                link.cell < link.across ? flux[link.face] : -flux[link.face];
            continue;
        }
        const label patchi = patches.whichPatch(link.face);
        values.links[i] =
            patches[patchi].coupled()
          ? flux.boundaryField()[patchi][link.face - patches[patchi].start()]
          : 0;
    }
    setCells(flux, values.cells);
}


void Foam::fsi::cutConvection::findCells()
{
    for (const label celli : cells_)
    {
        placeOf_[celli] = -1;
    }
    cells_.clear();
    const fvMesh& mesh = geometry_.grid().mesh();
    const boolList& fluid = geometry_.fluidCell();
    const auto add = [&](const label celli)
    {
        if (fluid[celli] && placeOf_[celli] < 0)
        {
            placeOf_[celli] = cells_.size();
            cells_.append(celli);
        }
    };
    for (const label facei : geometry_.nearFaces())
    {
        add(mesh.faceOwner()[facei]);
        if (facei < mesh.nInternalFaces())
        {
            add(mesh.faceNeighbour()[facei]);
        }
    }
}


void Foam::fsi::cutConvection::setCells
(
    const surfaceScalarField& flux,
    scalarField& net
) const
{
    net.setSize(cells_.size());
    if (cells_.empty())
    {
        return;
    }
    const lduAddressing& address = flux.mesh().lduAddr();
    const labelUList& firstOwned = address.ownerStartAddr();
    const labelUList& firstOther = address.losortStartAddr();
    const labelUList& others = address.losortAddr();
    forAll(cells_, i)
    {
        const label celli = cells_[i];
        scalar sum = 0;
        for (label f = firstOwned[celli]; f < firstOwned[celli + 1]; ++f)
        {
            sum += flux[f];
        }
        for (label f = firstOther[celli]; f < firstOther[celli + 1]; ++f)
        {
            sum -= flux[others[f]];
        }
        net[i] = sum;
    }
    for (const fvsPatchScalarField& pf : flux.boundaryField())
    {
        // Momentum that leaves the domain is not lost to objects
        const labelUList& cells = pf.patch().faceCells();
        for (label i = 0; i < pf.size() && pf.coupled(); ++i)
        {
            if (placeOf_[cells[i]] >= 0)
            {
                net[placeOf_[cells[i]]] += pf[i];
            }
        }
    }
}


void Foam::fsi::cutConvection::addLinks
(
    const volVectorField& U,
    const vectorField& mean,
    vectorField& nodal
) const
{
    vectorList across;
    swapCoupledCells(U.mesh(), U.primitiveField(), across);
    const label nInternal = U.mesh().nInternalFaces();
    const UList<wallLink>& links = geometry_.wallLinks();
    forAll(links, i)
    {
        const wallLink& link = links[i];
        const vector& wall =
            link.across >= 0
          ? U[link.across]
          : across[link.face - nInternal];
        const vector& v = mean[link.place.object];
        const vector loss
        (
            convecting_.links[i]*(0.5*(U[link.cell] + wall) - v)
          - final_.links[i]*(wall - v)
        );
        link.place.spread(nodal, loss);
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::cutConvection::cutConvection(const interfaceGeometry& geometry)
:
    geometry_(geometry),
    placeOf_(geometry.grid().mesh().nCells(), -1)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::cutConvection::begin(const surfaceScalarField& flux)
{
    findCells();
    set(flux, convecting_);
}


void Foam::fsi::cutConvection::addLoss
(
    const levelSetUpdate& levelSet,
    const surfaceSet& surfaces,
    const volVectorField& U,
    const vectorField& v,
    partialForces& nodal
) const
{
    // Relative to the mean velocity of an object, to which all fluxes add up to
    // nothing, but for the tolerance of the pressure
    const vectorField mean(objectMeans(surfaces, v));
    addLinks(U, mean, nodal.mine());

    // Farther cells have no cut faces, and some ranks do not know them as near
    const vectorField& C = U.mesh().C();
    const labelList& haloIndex = geometry_.grid().haloIndex();
    const scalar reach = 1.5*geometry_.grid().spacing();
    labelList face(1);
    label found;
    forAll(cells_, i)
    {
        const label celli = cells_[i];
        const label here = haloIndex[celli];
        face[0] = levelSet.nearestFace(here);
        if (face[0] >= 0 && levelSet.cellDistance()[here] < reach)
        {
            const surfacePlace place
            (
                nearestPlace(surfaces, C[celli], face, found)
            );
            const vector& ofAll = mean[place.object];
            const vector loss
            (
                final_.cells[i]*(place.interpolate(v) - ofAll)
              - convecting_.cells[i]*(U[celli] - ofAll)
            );
            place.spread(nodal.mine(), loss);
        }
    }
}


// ************************************************************************* //
