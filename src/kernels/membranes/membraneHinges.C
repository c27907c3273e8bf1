// SPDX-License-Identifier: GPL-3.0-or-later

#include "membraneHinges.H"
#include "facesAcross.H"
#include "laneVector.H"
#include "membraneLaw.H"
#include "vectorClones.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- Weight of a hinge between triangles: 2/sqrt(3)
static constexpr scalar perHinge = 1.1547005383792515;


//- Forces of all hinges
FSI_AVX2_CLONES
static void addHingeForces
(
    const UList<membraneHinges::hinge>& hinges,
    const scalar kappa,
    const double* x,
    double* force,
    double* energy
)
{
    typedef laneArray<membraneLaw::nLanes> Array;
    typedef laneVector<Array> vectors;
    Array sum(Array::load(energy));
    for (const membraneHinges::hinge& h : hinges)
    {
        const vectors a(vectors::load(x, h.nodes[0]));
        const bool inPlane = h.nodes[1] < 0;
        const vectors edge
        (
            inPlane
          ? vectors{Array(0), Array(0), Array(1)}
          : vectors::load(x, h.nodes[1]) - a
        );
        const vectors u(vectors::load(x, h.nodes[2]) - a);
        const vectors v(vectors::load(x, h.nodes[3]) - a);
        const vectors nA(edge ^ u);
        const vectors nB(v ^ edge);
        const Array perA(Array(1)/(nA & nA)), perB(Array(1)/(nB & nB));
        const Array lengthSqr(edge & edge);
        const Array length(lengthSqr.sqrt());
        const Array perAB((perA*perB).sqrt());
        const Array cosine((nA & nB)*perAB);
        const Array sine(((nA ^ nB) & edge)*perAB/length);
        const Array c0(h.cosine), s0(h.sine), stiffness(h.weight*kappa);
        sum += stiffness*(Array(1) - cosine*c0 - sine*s0);

        // dE/dtheta over the edge's length, with the normals over their squares
        const Array moment
        (
            stiffness*(sine*c0 - cosine*s0)/length
        );
        const vectors mA((moment*perA)*nA);
        const vectors mB((moment*perB)*nB);
        const Array uAlong(u & edge), vAlong(v & edge);

        // The angle falls where the third node of a triangle goes outward
        vectors::add(force, h.nodes[2], lengthSqr*mA);
        vectors::add(force, h.nodes[3], lengthSqr*mB);
        if (!inPlane)
        {
            vectors::subtract(force, h.nodes[1], uAlong*mA + vAlong*mB);
        }
        vectors::subtract
        (
            force,
            h.nodes[0],
            (lengthSqr - uAlong)*mA + (lengthSqr - vAlong)*mB
        );
    }
    sum.store(energy);
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::membraneHinges::setRest
(
    const UList<point>& points,
    const bool flat,
    const scalar weight,
    hinge& h
)
{
    const point& a = points[h.nodes[0]];
    const vector edge
    (
        h.nodes[1] < 0 ? vector(0, 0, 1) : vector(points[h.nodes[1]] - a)
    );
    const vector nA(edge ^ (points[h.nodes[2]] - a));
    const vector nB((points[h.nodes[3]] - a) ^ edge);
    const scalar area = mag(nA)*mag(nB);
    h.weight = weight;
    h.cosine = flat ? 1 : (nA & nB)/area;
    h.sine = flat ? 0 : ((nA ^ nB) & edge)/(area*mag(edge));
}


void Foam::fsi::membraneHinges::setEdges
(
    const UList<point>& points,
    const UList<surfaceFace>& faces,
    const bool flat
)
{
    List<FixedList<label, 3>> across(faces.size());
    setFacesAcross(faces, 0, faces.size(), across);
    hinges_.setSize(3*faces.size()/2);
    label n = 0;
    forAll(faces, facei)
    {
        for (label i = 0; i < 3; ++i)
        {
            const label other = across[facei][i];
            if (other < facei)
            {
                continue;
            }
            hinge& h = hinges_[n++];
            h.nodes[0] = faces[facei][(i + 1) % 3];
            h.nodes[1] = faces[facei][(i + 2) % 3];
            h.nodes[2] = faces[facei][i];
            for (const label nodei : faces[other])
            {
                if (nodei != h.nodes[0] && nodei != h.nodes[1])
                {
                    h.nodes[3] = nodei;
                }
            }
            setRest(points, flat, perHinge, h);
        }
    }
    hinges_.setSize(n);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::membraneHinges::membraneHinges
(
    const UList<point>& points,
    const UList<surfaceFace>& faces,
    const bool flat,
    const scalar depth
)
{
    if (faces[0][2] >= 0)
    {
        setEdges(points, faces, flat);
        return;
    }
    hinges_.setSize(points.size());
    for (const surfaceFace& f : faces)
    {
        hinges_[f[0]].nodes[3] = f[1];
        hinges_[f[1]].nodes[2] = f[0];
    }
    forAll(hinges_, i)
    {
        FixedList<label, 4>& nodes = hinges_[i].nodes;
        nodes[0] = i;
        nodes[1] = -1;
        const scalar length =
            0.5*mag(points[nodes[2]] - points[i])
          + 0.5*mag(points[nodes[3]] - points[i]);
        setRest(points, flat, depth/length, hinges_[i]);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::membraneHinges::addForces
(
    const scalar kappa,
    const double* x,
    double* force,
    double* energy
) const
{
    addHingeForces(hinges_, kappa, x, force, energy);
}


// ************************************************************************* //
