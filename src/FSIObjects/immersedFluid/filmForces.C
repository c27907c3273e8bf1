// SPDX-License-Identifier: GPL-3.0-or-later

#include "filmForces.H"
#include "swapCoupledCells.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::fsi::filmForces::mean
(
    const vectorField& source,
    const label facei
) const
{
    const fvMesh& mesh = geometry_.grid().mesh();
    const label inBoundary = facei - mesh.nInternalFaces();
    const boolList& fluid = geometry_.fluidCell();
    const label own = mesh.faceOwner()[facei];
    const label nei = inBoundary < 0 ? mesh.faceNeighbour()[facei] : own;
    const bool there =
        inBoundary < 0 ? fluid[nei] : geometry_.fluidAcross()[inBoundary];

    // Fluid cells alone, if there is one
    const bool both = fluid[own] == there;
    vector sum(Zero);
    if (both || fluid[own])
    {
        sum = source[own];
    }
    if (inBoundary < 0 && (both || there))
    {
        sum += source[nei];
    }
    return
        faces_.along(sum, facei)
       /((both ? 2 : 1)*geometry_.grid().cellVolume());
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::filmForces::filmForces
(
    const interfaceGeometry& geometry,
    const faceVelocities& faces
)
:
    geometry_(geometry),
    faces_(faces),
    others_(false)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::filmForces::begin
(
    const bool others,
    const vectorField& source
)
{
    const UList<filmFace>& films = geometry_.films().faces();
    others_ = others;
    before_.setSize(others ? films.size() : 0);
    forAll(before_, i)
    {
        before_[i] = mean(source, films[i].face);
    }
}


void Foam::fsi::filmForces::end
(
    const vector& acceleration,
    const vectorField& source
)
{
    const UList<filmFace>& films = geometry_.films().faces();
    along_.setSize(films.size());
    forAll(films, i)
    {
        along_[i] = faces_.along(acceleration, films[i].face);
    }
    if (!others_)
    {
        return;
    }

    const fvMesh& mesh = geometry_.grid().mesh();
    const label nInternal = mesh.nInternalFaces();
    scalarField onBoundary;
    setZeroOnCoupled(mesh, onBoundary);
    scalarList added(films.size());
    forAll(films, i)
    {
        added[i] = mean(source, films[i].face) - before_[i];
        if (films[i].face >= nInternal)
        {
            onBoundary[films[i].face - nInternal] = added[i];
        }
    }
    scalarList across;
    swapCoupledFaces(mesh, onBoundary, across);
    forAll(films, i)
    {
        if (films[i].face >= nInternal)
        {
            // Both sides get the same value to the last bit
            added[i] -= across[films[i].face - nInternal];
        }
        along_[i] += added[i];
    }
}


// ************************************************************************* //
