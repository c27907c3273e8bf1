// SPDX-License-Identifier: GPL-3.0-or-later

#include "membraneLimits.H"
#include "immersedBodies.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- 1 where two matrices are equal, else 0
Eigen::MatrixXd unchanged(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b)
{
    return (a.array() == b.array()).cast<Foam::scalar>();
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::membraneLimits::keepVolumes
(
    const label groupi,
    const scalar deltaT,
    const Eigen::MatrixXd& carried,
    Eigen::MatrixXd& v
) const
{
    const auto& group =
        dynamic_cast<const immersedBodies&>(bodies_.groups()[groupi]);
    Eigen::MatrixXd free(unchanged(v, carried));
    for (label i = 0; i < maxCorrections; ++i)
    {
        group.keepVolume(deltaT, free, v);
        const Eigen::MatrixXd corrected(v);
        walls_.limit(groupi, v);
        if (v == corrected)
        {
            break;
        }
        free = free.cwiseProduct(unchanged(v, corrected));
    }
}


void Foam::fsi::membraneLimits::carry
(
    const label groupi,
    const boolList& passes,
    Eigen::MatrixXd& v
) const
{
    const bodyGroup& group = bodies_.groups()[groupi];
    const label nDims = bodies_.nDims();
    boolList carried(group.size());
    bool any = false;
    forAll(carried, copyi)
    {
        carried[copyi] = passes[bodies_.objectIndex(groupi, copyi)];
        any = any || carried[copyi];
        if (carried[copyi])
        {
            const vector mean(group.velocity(copyi));
            v.middleCols(nDims*copyi, nDims).rowwise() =
                Eigen::RowVector3d(mean.x(), mean.y(), mean.z()).head(nDims);
        }
    }
    if (!any)
    {
        return;
    }
    Eigen::MatrixXd limited(v);
    walls_.limit(groupi, limited);
    limited -= v;
    for (label column = 0; column < v.cols(); ++column)
    {
        if (carried[column/nDims])
        {
            v.col(column).array() +=
                max(limited.col(column).maxCoeff(), scalar(0))
              + min(limited.col(column).minCoeff(), scalar(0));
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::membraneLimits::membraneLimits
(
    const fsiObjects& objects,
    const scalar least
)
:
    bodies_(objects.bodies()),
    walls_(objects)
{
    if (least > 0)
    {
        const cartesianMesh& grid = objects.grid();
        apart_.reset
        (
            new membraneDefence(bodies_, grid.period(), grid.spacing(), least)
        );
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::membraneLimits::set
(
    const surfaceSet& surfaces,
    const scalar deltaT,
    const boolList& passes,
    const nodeLayout::groupNodal& fluid,
    const nodeLayout::groupNodal& slip,
    nodeLayout::groupNodal& v
)
{
    walls_.find(surfaces, deltaT);
    nodeLayout::groupNodal carried(v.size());
    forAll(v, groupi)
    {
        if (!bodies_.groups()[groupi].hasWalls())
        {
            v[groupi] = fluid[groupi];
            walls_.addFaded(groupi, slip[groupi], v[groupi]);
            carried[groupi] = v[groupi];
            walls_.limit(groupi, v[groupi]);
        }
    }
    if (apart_.valid())
    {
        apart_->limit(deltaT, v);
    }
    forAll(v, groupi)
    {
        if (!bodies_.groups()[groupi].hasWalls())
        {
            keepVolumes(groupi, deltaT, carried[groupi], v[groupi]);
            carry(groupi, passes, v[groupi]);
        }
    }
}


// ************************************************************************* //
