// SPDX-License-Identifier: GPL-3.0-or-later

#include "cartesianLattice.H"
#include "lduMesh.H"
#include "latticeRanks.H"
#include "openfoamMesh.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{
    defineTypeNameAndDebug(cartesianLattice, 0);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::cartesianLattice::cartesianLattice(const polyMesh& mesh)
:
    keptWithMesh<cartesianLattice>(mesh),
    map_(mesh),
    partition_(map_),
    layout_(partition_.layout(rank())),
    transfer_(map_, partition_)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

const Foam::polyMesh& Foam::fsi::cartesianLattice::meshOf
(
    const lduMesh& mesh
)
{
    const polyMesh* found = dynamic_cast<const polyMesh*>(&mesh);
    if (!found)
    {
        FatalErrorInFunction
            << "cartesianMG and cartesianFFT solve equations of a mesh of "
            << "cells only, not those of a coarse GAMG level or a finite-area "
            << "mesh. Use GAMG there." << exit(FatalError);
    }
    return *found;
}


Foam::label Foam::fsi::cartesianLattice::rank() const
{
    return rankIn(comm());
}


Foam::label Foam::fsi::cartesianLattice::nRanks() const
{
    return nRanksIn(comm());
}


// ************************************************************************* //
