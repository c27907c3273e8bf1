// SPDX-License-Identifier: GPL-3.0-or-later

#include "filmProfiles.H"
#include "openLaplacian.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::fsi::filmProfiles::rise
(
    const filmFace& film,
    const volScalarField& p,
    List<scalarField>& ofPatches
) const
{
    const fvMesh& mesh = p.mesh();
    const cartesianMesh& grid = geometry_.grid();
    const scalar sign = grid.faceAlong(film.face) ? 1 : -1;
    if (film.face < mesh.nInternalFaces())
    {
        return
            sign
           *(
                p[mesh.faceNeighbour()[film.face]]
              - p[mesh.faceOwner()[film.face]]
            );
    }
    const label patchi = mesh.boundaryMesh().whichPatch(film.face);
    const fvPatchScalarField& pp = p.boundaryField()[patchi];
    if (ofPatches[patchi].empty())
    {
        ofPatches[patchi] = normalGradient(pp);
    }
    return
        sign*grid.spacing()
       *ofPatches[patchi][film.face - pp.patch().start()];
}


void Foam::fsi::filmProfiles::addForce
(
    const filmFace& film,
    const FixedList<scalar, 2>& ofEnds
)
{
    vector sum(Zero);
    forAll(ofEnds, k)
    {
        const filmEnd& end = film.ends[k];
        forAll(end.sides, i)
        {
            const vector force(ofEnds[k]*end.normals[i]);
            end.sides[i].spread(force_, force);
            sum += force;
        }
    }
    forAll(film.sides, i)
    {
        film.sides[i].spread(force_, vector(-0.5*sum));
    }
}


Foam::FixedList<Foam::scalar, 2> Foam::fsi::filmProfiles::opened
(
    const filmFace& film,
    const vectorField& velocity
)
{
    const vector u(film.meanVelocity(velocity));
    FixedList<scalar, 2> s;
    forAll(s, k)
    {
        s[k] = film.perOpening*film.ends[k].opening(velocity, u);
    }
    return s;
}


Foam::scalar Foam::fsi::filmProfiles::pushed
(
    const filmFace& film,
    const FixedList<scalar, 2>& s
)
{
    const FixedList<scalar, 6>& m = film.profile;
    return -(m[1]*s[0] + m[2]*s[1])/m[0];
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::filmProfiles::filmProfiles
(
    interfaceGeometry& geometry,
    const fluidProperties& fluid
)
:
    geometry_(geometry),
    fluid_(fluid)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::filmProfiles::begin(const vectorField& velocity)
{
    velocity_ = velocity;
}


void Foam::fsi::filmProfiles::next
(
    pressurePasses& passes,
    const vectorField& found
)
{
    if (passes.refused())
    {
        velocity_ = last_;
        return;
    }
    last_ = velocity_;
    velocity_ = passes.beside(found);
}


void Foam::fsi::filmProfiles::setForce
(
    const volScalarField& p,
    const scalar tau
)
{
    const cartesianMesh& grid = geometry_.grid();
    const label nInternal = p.mesh().nInternalFaces();
    List<scalarField> ofPatches(p.boundaryField().size());
    force_.setSize(velocity_.size());
    force_ = Zero;
    for (const filmFace& film : geometry_.films().faces())
    {
        if (film.perOpening <= 0)
        {
            continue;
        }
        const FixedList<scalar, 6>& m = film.profile;
        const FixedList<scalar, 2> s(opened(film, velocity_));

        const scalar friction =
            12*fluid_.viscosity*film.viscosity/sqr(film.gap);
        const scalar kept =
            geometry_.films().kept(film.face, tau, fluid_.viscosity);
        const scalar beside =
            (1 - kept)
           *(
                pushed(film, s)
              - rise(film, p, ofPatches)/(grid.spacing()*friction*m[0])
            );
        // Both sides of a coupled patch have half of it each
        const scalar force =
            (film.face < nInternal ? 1 : 0.5)
           *fluid_.density*friction*film.perOpening
           *grid.cellVolume()*geometry_.openness()[film.face];
        addForce
        (
            film,
            FixedList<scalar, 2>
            ({
                force*(m[1]*beside + m[3]*s[0] + m[4]*s[1]),
                force*(m[2]*beside + m[4]*s[0] + m[5]*s[1])
            })
        );
    }
}


void Foam::fsi::filmProfiles::push
(
    const vectorField& velocity,
    const scalar tau
)
{
    const vectorField& v = answered(tau) > 0 ? velocity : velocity_;
    const UList<filmFace>& films = geometry_.films().faces();
    scalarList velocities(films.size(), Zero);
    forAll(films, filmi)
    {
        const filmFace& film = films[filmi];
        if (film.perOpening > 0)
        {
            velocities[filmi] = pushed(film, opened(film, v));
        }
    }
    geometry_.setPushed(velocities);
}


// ************************************************************************* //
