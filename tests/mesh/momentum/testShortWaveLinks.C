// SPDX-License-Identifier: GPL-3.0-or-later

// The resistance to the shortest wave of a surface in the wall links and in the
// friction (5.17), (5.25), over that of Stokes flow. Cells of size 1

#include <gtest/gtest.h>

#include "discSurfaces.H"
#include "mathematicalConstants.H"
#include "randomNumbers.H"
#include "shortWaves.H"
#include "sphereSurfaces.H"
#include "surfacesInBox.H"

using namespace Foam;
using namespace Foam::fsi;

namespace
{

const scalar pi = constant::mathematical::pi;


//- A surface with nodes about 0.8 cells from each other
class wavySurface
:
    public surfacesInBox
{
    const direction nDims_;
    List<shortWaves::fourNodes> waves_;
    scalarField areas_;

    //- Friction for the viscosity 1
    vectorField friction(const vectorField& v) const
    {
        vectorField force(v.size(), Zero);
        for (const auto& four : waves_)
        {
            four.addForce(0, four.friction(1), v, force);
        }
        return force;
    }

public:

    explicit wavySurface(const direction nDims)
    :
        surfacesInBox
        (
            nDims == 2 ? labelVector(32, 20, 1) : labelVector(24, 20, 18),
            nDims,
            0
        ),
        nDims_(nDims)
    {
        const List<point> disc({point(15.7, 10.2, 0)});
        const List<point> sphere({point(11.7, 10.2, 8.9)});
        move
        (
            nDims == 2
          ? discSurfaces(disc, 7.1, 56)
          : sphereSurfaces(sphere, 7.1, 4)
        );
        const surfaceSet& s = surfaces();
        waves_ = shortWaves::all(s.points(), s.faces(), nDims, 1);
        areas_.setSize(s.points().size(), Zero);
        forAll(s.faces(), facei)
        {
            for (label i = 0; i < s.nNodes(); ++i)
            {
                areas_[s.faces()[facei][i]] +=
                    mag(s.areaNormal(facei))/s.nNodes();
            }
        }
    }

    //- The wave that the friction resists most
    vectorField shortest() const
    {
        randomNumbers random(5);
        vectorField v(surfaces().points().size());
        for (vector& vi : v)
        {
            vi = random.sample01<vector>() - vector::uniform(0.5);
        }
        for (label i = 0; i < 60; ++i)
        {
            v = friction(v);
            v /= max(mag(v));
        }
        return v;
    }

    //- Power of the friction
    scalar ofFriction(const vectorField& v) const
    {
        return -sum(friction(v) & v);
    }

    //- Power of the links in a fluid at rest: the most that they can take
    scalar ofLinks(const vectorField& v) const
    {
        scalar power = 0;
        for (const wallLink& link : geometry().wallLinks())
        {
            power += link.conductance*magSqr(link.place.interpolate(v));
        }
        return returnReduce(power, sumOp<scalar>());
    }

    //- Power of the stress 2 mu k v, of all nodes with their own k
    scalar ofStokes(const vectorField& v) const
    {
        scalar power = 0;
        forAll(v, i)
        {
            const scalar k =
                nDims_ == 2
              ? pi/areas_[i]
              : 4*pi/3*Foam::sqrt(Foam::sqrt(0.75)/areas_[i]);
            power += 2*k*areas_[i]*magSqr(v[i]);
        }
        return power;
    }
};

} // End anonymous namespace


TEST(shortWaves, linksTakeLittleOfTheShortestAndFrictionTheRest)
{
    for (direction nDims = 2; nDims <= 3; ++nDims)
    {
        const wavySurface surface(nDims);
        const vectorField v(surface.shortest());
        const scalar stokes = surface.ofStokes(v);
        const scalar links = surface.ofLinks(v)/stokes;
        const scalar friction = surface.ofFriction(v)/stokes;
        std::cout
            << "shortest wave in " << nDims << " dimensions: links "
            << links << ", friction " << friction << " of Stokes flow's"
            << std::endl;
        EXPECT_LT(links, 0.5);
        EXPECT_NEAR(friction, 1, 0.3);

        // A translation is resisted by the links alone
        const vectorField along(v.size(), vector(1, 2, 0));
        EXPECT_GT(surface.ofLinks(along), 1e6*surface.ofFriction(along));
    }
}


// ************************************************************************* //
