// SPDX-License-Identifier: GPL-3.0-or-later

#include "wallDefence.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::label Foam::fsi::wallDefence::cellOf(point& x) const
{
    const point least(grid_.bounds().min());
    for (direction d = 0; d < grid_.nDims(); ++d)
    {
        const scalar period = grid_.period()[d];
        if (period > 0)
        {
            x[d] -= period*std::floor((x[d] - least[d])/period);
        }
    }
    // Blocks of ranks may overlap, cells do not
    const label celli = grid_.findCell(x);
    return celli < 0 ? -1 : grid_.haloIndex()[celli];
}


void Foam::fsi::wallDefence::setFacesNear
(
    const label celli,
    DynamicList<label>& faces
) const
{
    const cartesianBlock halo(grid_.cells(1));
    const labelVector centre(halo.ijk(celli));
    const label k = grid_.nDims() == 3 ? 1 : 0;
    faces.clear();
    for (label dz = -k; dz <= k; ++dz)
    {
        for (label dy = -1; dy <= 1; ++dy)
        {
            for (label dx = -1; dx <= 1; ++dx)
            {
                faces.append
                (
                    levelSet_.nearestFace
                    (
                        halo.index(centre + labelVector(dx, dy, dz))
                    )
                );
            }
        }
    }
}


template<class Action>
void Foam::fsi::wallDefence::forNearNodes
(
    const surfaceSet& surfaces,
    const Action& action
) const
{
    // The nearest place is at most half a diagonal farther from the centre of
    // the cell than from the node
    const scalar far = 1.87*grid_.spacing();
    const surfaceSet& mine = bodies_.surfaces();
    DynamicList<label> faces;
    label found;
    for (label objecti = 0; objecti < mine.size(); ++objecti)
    {
        if (mine.hasWalls(objecti))
        {
            continue;
        }
        const label end = mine.pointStart()[objecti + 1];
        for (label i = mine.pointStart()[objecti]; i < end; ++i)
        {
            point x(mine.points()[i]);
            const label here = cellOf(x);
            if
            (
                here < 0 || levelSet_.nearestFace(here) < 0
             || levelSet_.cellDistance()[here] > far
            )
            {
                continue;
            }
            setFacesNear(here, faces);
            const surfacePlace place(nearestPlace(surfaces, x, faces, found));
            FixedList<scalar, 3> weights;
            const vector away(x - surfaces.nearestOnFace(found, x, weights));
            const vector outward(surfaces.areaNormal(found));
            const scalar gap = sign(away & outward)*mag(away);
            const vector n
            (
                mag(gap) > 1e-3*grid_.spacing()
              ? away/gap
              : outward/mag(outward)
            );
            action(i, place, gap, n);
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::wallDefence::find
(
    const surfaceSet& surfaces,
    const scalar deltaT
)
{
    deltaT_ = deltaT;
    if (bodies_.onlyMembranes())
    {
        return;
    }
    const scalar least = smallest*grid_.spacing();
    const vectorField& velocities = bodies_.surfaces().velocities();
    vectorField near(velocities.size(), Zero), along(near);
    const auto set = [&]
    (
        const label nodei,
        const surfacePlace& place,
        const scalar gap,
        const vector& n
    )
    {
        const scalar ofWall = place.interpolate(velocities) & n;
        near[nodei] = min(max(1 - gap/grid_.spacing(), SMALL), scalar(1))*n;
        along[nodei] = (ofWall + (min(gap, least) - gap)/deltaT)*n;
    };
    forNearNodes(surfaces, set);
    bodies_.ranks().collect
    ({
        objectRanks::values::ofNodes(near),
        objectRanks::values::ofNodes(along)
    });
    bodies_.layout().toGroups(near, near_);
    bodies_.layout().toGroups(along, least_);
}


void Foam::fsi::wallDefence::addFaded
(
    const label groupi,
    const Eigen::MatrixXd& slip,
    Eigen::MatrixXd& v
) const
{
    const boundBox box(grid_.bounds());
    const label nDims = grid_.nDims();
    const Eigen::MatrixXd& x = bodies_.groups()[groupi].positions();
    for (Eigen::Index column = 0; column < v.cols(); column += nDims)
    {
        Eigen::ArrayXd part(Eigen::ArrayXd::Ones(v.rows()));
        for (label d = 0; d < nDims; ++d)
        {
            const auto along = x.col(column + d).array();
            if (grid_.period()[d] == 0)
            {
                part *=
                    (
                        (along - box.min()[d]).min(box.max()[d] - along)
                       /grid_.spacing()
                    ).max(0).min(1);
            }
        }
        if (near_.size())
        {
            part *=
                1 - near_[groupi].middleCols(column, nDims).rowwise().norm()
               .array();
        }
        v.middleCols(column, nDims) +=
            part.matrix().asDiagonal()*slip.middleCols(column, nDims);
    }
}


void Foam::fsi::wallDefence::limitAtSides
(
    const label groupi,
    Eigen::MatrixXd& v
) const
{
    const label nDims = grid_.nDims();
    const scalar h = grid_.spacing();
    const Eigen::MatrixXd& x = bodies_.groups()[groupi].positions();
    const boundBox& box = sides_.bounds();
    for (const contactWall& wall : sides_.walls())
    {
        direction d = 0;
        while (mag(wall.normal()[d]) < 0.5)
        {
            ++d;
        }
        const bool upper = wall.normal()[d] < 0;
        for (Eigen::Index column = 0; column < v.cols(); column += nDims)
        {
            const auto along = x.col(column + d);
            const scalar nearest =
                upper
              ? box.max()[d] - along.maxCoeff()
              : along.minCoeff() - box.min()[d];
            if (nearest < h)
            {
                limitAtSide(wall, x, column, v);
            }
        }
    }
}


void Foam::fsi::wallDefence::limitAtSide
(
    const contactWall& wall,
    const Eigen::MatrixXd& x,
    const Eigen::Index column,
    Eigen::MatrixXd& v
) const
{
    const scalar least = smallest*grid_.spacing();
    vector away;
    for (Eigen::Index i = 0; i < x.rows(); ++i)
    {
        point p(0, 0, bodies_.planeZ());
        vector velocity(Zero);
        for (direction d = 0; d < grid_.nDims(); ++d)
        {
            p[d] = x(i, column + d);
            velocity[d] = v(i, column + d);
        }
        const scalar gap = wall.gap(p, away);
        const scalar lacking =
            (min(gap, least) - gap)/deltaT_ - (velocity & away);
        for (direction d = 0; lacking > 0 && d < grid_.nDims(); ++d)
        {
            v(i, column + d) += lacking*away[d];
        }
    }
}


void Foam::fsi::wallDefence::limit
(
    const label groupi,
    Eigen::MatrixXd& v
) const
{
    const label nDims = grid_.nDims();
    const Eigen::Index end = near_.size() ? v.cols() : 0;
    for (Eigen::Index column = 0; column < end; column += nDims)
    {
        const auto near = near_[groupi].middleCols(column, nDims);
        const Eigen::MatrixXd n
        (
            near.array().colwise()
           /near.rowwise().norm().array().max(VSMALL)
        );
        const auto least = least_[groupi].middleCols(column, nDims);
        auto ofCopy = v.middleCols(column, nDims);
        const Eigen::VectorXd lacking
        (
            (least - ofCopy).cwiseProduct(n).rowwise().sum().cwiseMax(0)
        );
        ofCopy += lacking.asDiagonal()*n;
    }
    limitAtSides(groupi, v);
}


// ************************************************************************* //
