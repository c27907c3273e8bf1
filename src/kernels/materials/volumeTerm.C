// SPDX-License-Identifier: GPL-3.0-or-later

#include "volumeTerm.H"
#include "error.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

typedef strainDomains::kind domainKind;

//- Volumes of the triangles; fatal for one that is not positively oriented
static scalarField checkedVolumes(const shapeMesh& mesh, const scalar thickness)
{
    const scalarField volumes(mesh.elementVolumes()*thickness);
    forAll(volumes, elementi)
    {
        if (!(volumes[elementi] > 0))
        {
            FatalErrorInFunction
                << "Element " << elementi << " with nodes "
                << mesh.elements[elementi]
                << " is not positively oriented" << exit(FatalError);
        }
    }
    return volumes;
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::volumeTerm::volumeTerm
(
    const shapeMesh& mesh,
    const scalar thickness,
    const scalar stiffness,
    const bool smoothed
)
:
    stiffness_(stiffness),
    volumes_(checkedVolumes(mesh, thickness)),
    areaDomains_
    (
        mesh, thickness, smoothed ? domainKind::node : domainKind::triangle
    ),
    shearDomains_
    (
        mesh, thickness, smoothed ? domainKind::edge : domainKind::triangle
    )
{}


// ************************************************************************* //
