// SPDX-License-Identifier: GPL-3.0-or-later

#include "objectsConductance.H"
#include "labelPair.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;
using Foam::fsi::wallFace;

//- The wall faces of each cell that has any: chains of its sides, 2 i at the
//  lower cell of wall i and 2 i + 1 at the upper one
class cellWalls
{
    const UList<wallFace>& walls_;

    const Foam::fsi::wallOperator& operator_;

    //- First side of each cell, and the next one of each side; -1: none
    labelList first_;
    labelList next_;

    //- Place of a side's cell at walls, or -1
    label place(const label side) const
    {
        const wallFace& w = walls_[side/2];
        const label celli = side % 2 ? w.upper : w.lower;
        return celli < 0 ? -1 : operator_.place(celli);
    }

public:

    explicit cellWalls(const Foam::fsi::fsiSystem& system)
    :
        walls_(system.geometry.wallFaces()),
        operator_(system.walls),
        first_(system.walls.cells().size(), -1),
        next_(2*walls_.size(), -1)
    {
        forAllReverse(next_, side)
        {
            const label at = place(side);
            if (at >= 0)
            {
                next_[side] = first_[at];
                first_[at] = side;
            }
        }
    }

    //- Call action(place of a cell, component of a node, value) for all
    //  components that a cell's pressure acts on [m^2], once for each of them
    template<class Action>
    void forLoads(const Action& action) const
    {
        DynamicList<labelPair> places;
        DynamicList<scalar> values;
        forAll(next_, side)
        {
            const label at = place(side);
            if (at < 0 || first_[at] != side)
            {
                continue;
            }
            places.clear();
            values.clear();
            for (label s = side; s >= 0; s = next_[s])
            {
                addSide(s, places, values);
            }
            forAll(places, i)
            {
                action(at, places[i], values[i]);
            }
        }
    }

private:

    //- Add a side's loads, to those that are there already where possible
    void addSide
    (
        const label side,
        DynamicList<labelPair>& places,
        DynamicList<scalar>& values
    ) const
    {
        const wallFace& w = walls_[side/2];
        const scalar area = side % 2 ? -w.area : w.area;
        for (label k = 0; k < 3 && w.place.nodes[k] >= 0; ++k)
        {
            const labelPair place(w.place.nodes[k], w.dir);
            label i = 0;
            while (i < places.size() && places[i] != place)
            {
                ++i;
            }
            if (i == places.size())
            {
                places.append(place);
                values.append(0);
            }
            values[i] += area*w.place.weights[k];
        }
    }
};

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::objectsConductance::rowSums(scalarField& d) const
{
    vectorField uniform(system_.walls.uniformForce());
    fsiSystem::groupNodal force;
    system_.toBoundary(uniform, force);

    const scalar dt = system_.deltaT();
    forAll(force, groupi)
    {
        if (system_.objects.groups()[groupi].free())
        {
            Eigen::MatrixXd v;
            system_.objects.groups()[groupi].response().matrix().solveBoundary
            (
                force[groupi],
                v
            );
            force[groupi] = (dt*system_.fluidDensity)*v;
        }
        else
        {
            force[groupi].setZero();
        }
    }
    system_.fromBoundary(force, uniform);
    system_.walls.addGrossFluxAtWalls(uniform, d);
}


void Foam::fsi::objectsConductance::nodeDiagonal(scalarField& d) const
{
    const scalar dt = system_.deltaT();
    const surfaceSet& surfaces = system_.objects.surfaces();

    // dt rho/A_ii per surface node and component
    vectorField mobility(surfaces.points().size(), Zero);
    forAll(surfaces.pointObject(), nodei)
    {
        const label objecti = surfaces.pointObject()[nodei];
        const label copyi = system_.objects.objectCopy(objecti);
        const bodyGroup& group =
            system_.objects.groups()[system_.objects.objectGroup(objecti)];
        if (group.free())
        {
            const responseMatrix& A = group.response().matrix();
            const label i = nodei - surfaces.pointStart()[objecti];
            for (direction d = 0; d < group.shape().nDims(); ++d)
            {
                mobility[nodei][d] =
                    dt*system_.fluidDensity/A.diagonal(copyi, i, d);
            }
        }
    }

    cellWalls(system_).forLoads
    (
        [&](const label at, const labelPair& place, const scalar value)
        {
            d[at] += sqr(value)*mobility[place.first()][place.second()];
        }
    );
}


Foam::scalarField Foam::fsi::objectsConductance::diagonal() const
{
    const label n = system_.walls.cells().size();
    scalarField rows(n, Zero), d(n, Zero);
    rowSums(rows);
    nodeDiagonal(d);
    forAll(d, at)
    {
        d[at] = max(max(rows[at], d[at]), 0.0);
    }
    return d;
}


// ************************************************************************* //
