// SPDX-License-Identifier: GPL-3.0-or-later

#include "population.H"
#include "SubField.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- Copy the boundary rows of a copy to its place in the surface layout
static void boundaryRows
(
    const Eigen::MatrixXd& rows,
    const label copyi,
    const direction nDims,
    SubField<vector> surfaceNodal
)
{
    const label column = nDims*copyi;
    forAll(surfaceNodal, nodei)
    {
        for (direction d = 0; d < nDims; ++d)
        {
            surfaceNodal[nodei][d] = rows(nodei, column + d);
        }
    }
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::fsi::population::movesFreely(const label objecti) const
{
    return groups_[objectGroup_[objecti]].movesFreely();
}


void Foam::fsi::population::zeroGroups
(
    List<Eigen::MatrixXd>& groupNodal
) const
{
    groupNodal.resize(groups_.size());
    forAll(groups_, groupi)
    {
        groupNodal[groupi].setZero
        (
            shapes_[groupi].nNodes(),
            nDims_*groups_[groupi].size()
        );
    }
}


void Foam::fsi::population::updateSurfaces()
{
    pointField& points = surfaces_.points();
    vectorField& velocities = surfaces_.velocities();
    for (label objecti = 0; objecti < size(); ++objecti)
    {
        const bodyGroup& group = groups_[objectGroup_[objecti]];
        const label copyi = objectCopy(objecti);
        const label start = surfaces_.pointStart()[objecti];
        const label n = surfaces_.pointStart()[objecti + 1] - start;
        boundaryRows
        (
            group.positions(), copyi, nDims_,
            SubField<vector>(points, n, start)
        );
        boundaryRows
        (
            group.velocities(), copyi, nDims_,
            SubField<vector>(velocities, n, start)
        );
    }
}


void Foam::fsi::population::toGroups
(
    const vectorField& surfaceNodal,
    List<Eigen::MatrixXd>& groupNodal
) const
{
    zeroGroups(groupNodal);
    for (label objecti = 0; objecti < size(); ++objecti)
    {
        Eigen::MatrixXd& rows = groupNodal[objectGroup_[objecti]];
        const label column = nDims_*objectCopy(objecti);
        const label start = surfaces_.pointStart()[objecti];
        const label n = surfaces_.pointStart()[objecti + 1] - start;
        for (label nodei = 0; nodei < n; ++nodei)
        {
            for (direction d = 0; d < nDims_; ++d)
            {
                rows(nodei, column + d) = surfaceNodal[start + nodei][d];
            }
        }
    }
}


void Foam::fsi::population::toSurface
(
    const List<Eigen::MatrixXd>& groupNodal,
    vectorField& surfaceNodal
) const
{
    surfaceNodal.resize(surfaces_.points().size());
    surfaceNodal = Zero;
    for (label objecti = 0; objecti < size(); ++objecti)
    {
        const label start = surfaces_.pointStart()[objecti];
        const label n = surfaces_.pointStart()[objecti + 1] - start;
        boundaryRows
        (
            groupNodal[objectGroup_[objecti]], objectCopy(objecti), nDims_,
            SubField<vector>(surfaceNodal, n, start)
        );
    }
}


// ************************************************************************* //
