// SPDX-License-Identifier: GPL-3.0-or-later

#include "massPoints.H"
#include "surfaceMoments.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::massPoints::massPoints
(
    const shapeMesh& mesh,
    const direction nDims
)
:
    mesh_(mesh)
{
    mesh_.points.resize(mesh_.nBoundary);
    mesh_.elements.clear();

    surfaceSet surface(nDims);
    surface.append(mesh_.points, mesh_.faces);
    volume_ = surface.volume(0);

    const point centre(surface.centroid(0));
    const surfaceMoments moments(surface, 0, centre);
    vector axes[3] = {moments.longAxis(), moments.shortAxis(nDims)};
    if (nDims == 3)
    {
        axes[2] = axes[1];
        axes[1] = axes[2] ^ axes[0];
    }
    for (direction i = 0; i < nDims; ++i)
    {
        const vector arm
        (
            moments.halfLengths()[i]*std::sqrt(nDims/(nDims + 2.0))*axes[i]
        );
        mesh_.points.append(centre + arm);
        mesh_.points.append(centre - arm);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalarField Foam::fsi::massPoints::masses(const scalar mass) const
{
    const label nPoints = mesh_.points.size() - mesh_.nBoundary;
    scalarField masses(mesh_.points.size(), Zero);
    for (label i = mesh_.nBoundary; i < masses.size(); ++i)
    {
        masses[i] = mass/nPoints;
    }
    return masses;
}


// ************************************************************************* //
