// SPDX-License-Identifier: GPL-3.0-or-later

#include "stateChecks.H"
#include "openfoamVersion.H"

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::fsi::stateChecks::checkShape
(
    const dictionary& dict,
    const shapeTemplate& shape,
    const word& name,
    const direction nDims
)
{
    if (shape.name() != name)
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'name' in dictionary " << dict.name() << " is "
            << shape.name() << " but must be that of the file, " << name
            << exit(FatalIOError);
    }
    if (shape.nDims() != nDims)
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'nDims' in dictionary " << dict.name() << " is "
            << label(shape.nDims()) << " but uniform/fsiPopulation has "
            << label(nDims) << exit(FatalIOError);
    }
}


void Foam::fsi::stateChecks::checkIds
(
    const dictionary& state,
    const bodyGroup& group,
    const label nextObjectId,
    labelHashSet& taken
)
{
    for (const label id : group.objectIds())
    {
        const bool twice = !taken.insert(id);
        if (twice || id >= nextObjectId)
        {
            FatalIOErrorInFunction(state)
                << "Entry 'objectIds' in dictionary " << state.name()
                << " has the id " << id
                << (
                       twice
                     ? ", which another shape has as well"
                     : ", but must be below 'nextObjectId' of"
                       " uniform/fsiPopulation"
                   )
                << exit(FatalIOError);
        }
    }
}


void Foam::fsi::stateChecks::checkMesh
(
    const population& objects,
    const direction nDims,
    const boundBox& bounds,
    const scalar thickness
)
{
    if (objects.nDims() != nDims)
    {
        FatalErrorInFunction
            << "The objects have " << label(objects.nDims())
            << " dimensions but the mesh has " << label(nDims)
            << "; run seedObjects on this mesh" << exit(FatalError);
    }
    const bool planar = objects.nDims() == 2;
    if
    (
        planar
     && !(
            objects.planeZ() >= bounds.min().z() - SMALL
         && objects.planeZ() <= bounds.max().z() + SMALL
        )
    )
    {
        FatalErrorInFunction
            << "Entry 'planeZ' in uniform/fsiPopulation is "
            << objects.planeZ() << ", outside the mesh " << bounds
            << ": run seedObjects on this mesh" << exit(FatalError);
    }

    forAll(objects.groups(), groupi)
    {
        const bodyGroup& group = objects.groups()[groupi];
        const shapeTemplate& shape = group.shape();
        // Wide, for objects about to leave, and more for walls around vessels
        const vector far((group.movesFreely() ? 10 : 1000)*bounds.span());
        if (planar && mag(shape.thickness() - thickness) > 1e-6*thickness)
        {
            FatalErrorInFunction
                << "Entry 'thickness' in constant/fsiObjects/" << shape.name()
                << " is " << shape.thickness() << " but the mesh has "
                << thickness << ": run seedObjects on this mesh"
                << exit(FatalError);
        }
        const Eigen::MatrixXd& x = group.positions();
        for (Eigen::Index column = 0; column < x.cols(); ++column)
        {
            const direction d = column % objects.nDims();
            if
            (
                x.col(column).minCoeff() < bounds.min()[d] - far[d]
             || x.col(column).maxCoeff() > bounds.max()[d] + far[d]
            )
            {
                FatalErrorInFunction
                    << "Entry 'positions' in uniform/fsiObjects/"
                    << shape.name() << ": object "
                    << group.objectIds()[column/objects.nDims()]
                    << " is far from the domain " << bounds
                    << exit(FatalError);
            }
        }
    }
}


// ************************************************************************* //
