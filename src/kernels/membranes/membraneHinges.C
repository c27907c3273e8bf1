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

//- Energy per hinge: 2/sqrt(3)
static constexpr scalar perHinge = 1.1547005383792515;


//- Forces of all hinges; energy per hinge `stiffness` (1 - cos(change))
FSI_AVX2_CLONES
static void addHingeForces
(
    const UList<membraneHinges::hinge>& hinges,
    const scalar stiffness,
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
        const vectors edge(vectors::load(x, h.nodes[1]) - a);
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
        const Array c0(h.cosine), s0(h.sine);
        sum += Array(stiffness)*(Array(1) - cosine*c0 - sine*s0);

        // dE/dtheta over the edge's length, with the normals over their squares
        const Array moment
        (
            Array(stiffness)*(sine*c0 - cosine*s0)/length
        );
        const vectors mA((moment*perA)*nA);
        const vectors mB((moment*perB)*nB);
        const Array uAlong(u & edge), vAlong(v & edge);

        // The angle falls where the third node of a triangle goes outward
        vectors::add(force, h.nodes[2], lengthSqr*mA);
        vectors::add(force, h.nodes[3], lengthSqr*mB);
        vectors::subtract(force, h.nodes[1], uAlong*mA + vAlong*mB);
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


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::membraneHinges::membraneHinges
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
            const label a = faces[facei][(i + 1) % 3];
            const label b = faces[facei][(i + 2) % 3];
            label third = -1;
            for (const label nodei : faces[other])
            {
                third = nodei == a || nodei == b ? third : nodei;
            }
            const label first = faces[facei][i];
            const vector edge(points[b] - points[a]);
            const vector nA(edge ^ (points[first] - points[a]));
            const vector nB((points[third] - points[a]) ^ edge);
            const scalar area = mag(nA)*mag(nB);
            hinges_[n].nodes[0] = a;
            hinges_[n].nodes[1] = b;
            hinges_[n].nodes[2] = first;
            hinges_[n].nodes[3] = third;
            hinges_[n].cosine = flat ? 1 : (nA & nB)/area;
            hinges_[n].sine = flat ? 0 : ((nA ^ nB) & edge)/(area*mag(edge));
            ++n;
        }
    }
    hinges_.setSize(n);
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
    addHingeForces(hinges_, perHinge*kappa, x, force, energy);
}


// ************************************************************************* //
