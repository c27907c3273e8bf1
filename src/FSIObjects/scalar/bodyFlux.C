// SPDX-License-Identifier: GPL-3.0-or-later

#include "bodyFlux.H"
#include "objectMeans.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::bodyFlux::setMotions()
{
    const surfaceSet& surfaces = objects_.surfaces();
    const pointField& x = surfaces.points();
    const vectorField& v = surfaces.velocities();
    centres_ = objectMeans(surfaces, x);
    means_ = objectMeans(surfaces, v);
    linear_.setSize(centres_.size());
    forAll(linear_, objecti)
    {
        tensor moments(Zero), shears(Zero);
        const label end = surfaces.pointStart()[objecti + 1];
        for (label i = surfaces.pointStart()[objecti]; i < end; ++i)
        {
            const vector arm(x[i] - centres_[objecti]);
            moments += arm*arm;
            shears += (v[i] - means_[objecti])*arm;
        }
        if (surfaces.nDims() == 2)
        {
            moments.zz() = tr(moments);
        }
        linear_[objecti] = shears & inv(moments);
    }
}


Foam::vector Foam::fsi::bodyFlux::velocity(const label facei) const
{
    const surfaceSet& surfaces = objects_.surfaces();
    const levelSetUpdate& levelSet = objects_.levelSet();
    const label sample = surfaces_.innerSample(facei);
    const label objecti = levelSet.objectAt(sample);
    const point& x = objects_.grid().mesh().faceCentres()[facei];
    const label nearest = levelSet.nearestFace(sample);
    if (nearest >= 0)
    {
        FixedList<scalar, 3> weights;
        const point y(surfaces.nearestOnFace(nearest, x, weights));
        return
            surfaces.interpolate(surfaces.velocities(), nearest, weights)
          + (linear_[objecti] & (x - y));
    }
    vector arm(x - centres_[objecti]);
    const vector& period = objects_.grid().period();
    for (direction d = 0; d < 3; ++d)
    {
        if (period[d] > 0)
        {
            arm[d] -= period[d]*std::round(arm[d]/period[d]);
        }
    }
    return means_[objecti] + (linear_[objecti] & arm);
}


Foam::scalar Foam::fsi::bodyFlux::through(const label facei) const
{
    const scalarSurfaces::surface* body = surfaces_.permeableAt(facei);
    const scalar closed =
        1
      - 0.5*(geometry_.openness()[facei] + geometry_.lastOpenness()[facei]);
    if (!body || closed <= 0)
    {
        return 0;
    }
    const cartesianMesh& grid = objects_.grid();
    const scalar along = velocity(facei)[grid.faceDirection(facei)];
    return
        body->partition*closed*grid.faceArea()
       *(grid.faceAlong(facei) ? along : -along);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::bodyFlux::addTo(surfaceScalarField& flux)
{
    setMotions();
    forAll(flux, facei)
    {
        flux[facei] += through(facei);
    }
    for (fvsPatchScalarField& pf : flux.boundaryFieldRef())
    {
        const polyPatch& patch = pf.patch().patch();
        const bool passes = pf.coupled() || domainSides::isOpen(patch);
        for (label i = 0; i < pf.size() && passes; ++i)
        {
            pf[i] += through(patch.start() + i);
        }
    }
}


// ************************************************************************* //
