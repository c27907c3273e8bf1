// SPDX-License-Identifier: GPL-3.0-or-later

#include "openVolumes.H"
#include "openVolume.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- Open part of a cell from the distances at its corners
static scalar openPart
(
    const cartesianBlock& corners,
    const scalarField& distance,
    const labelVector& ijk
)
{
    // Around the lower face, and above
    static const label x[] = {0, 1, 1, 0};
    static const label y[] = {0, 0, 1, 1};
    FixedList<scalar, 8> values;
    for (label i = 0; i < (corners.nDims() == 2 ? 4 : 8); ++i)
    {
        const labelVector corner(x[i % 4], y[i % 4], i/4);
        values[i] = distance[corners.index(ijk + corner)];
    }
    return
        corners.nDims() == 2
      ? openSquare({values[0], values[1], values[2], values[3]})
      : openCube(values);
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::tmp<Foam::scalarField> Foam::fsi::openVolumes
(
    const fsiObjects& objects,
    const interfaceGeometry& geometry,
    const scalarSurfaces& surfaces
)
{
    const cartesianMesh& grid = objects.grid();
    const cartesianBlock cells(grid.cells());
    const cartesianBlock corners(grid.corners());
    const scalarField& distance = objects.levelSet().cellDistance();
    const scalarField& atCorners = objects.levelSet().cornerDistance();
    const scalar whole = grid.cellVolume();
    auto topen = newTmp<scalarField>(grid.mesh().nCells());
    scalarField& open = topen.ref();
    forAll(open, celli)
    {
        const scalar away = distance[grid.haloIndex()[celli]];
        const bool full =
            surfaces.fixed()[celli]
         || surfaces.beside()[celli]
         || away > grid.spacing();
        open[celli] =
            full ? 1
          : !geometry.activeCell()[celli] ? 0
          : openPart(corners, atCorners, cells.ijk(grid.blockIndex()[celli]));
    }
    open *= whole;
    return topen;
}


// ************************************************************************* //
