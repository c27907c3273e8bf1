// SPDX-License-Identifier: GPL-3.0-or-later

#include "volumeTerm.H"
#include "error.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

typedef strainDomains::kind domainKind;

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
    volumes_(mesh.elementVolumes()*thickness),
    areaDomains_
    (
        mesh, thickness, smoothed ? domainKind::node : domainKind::triangle
    ),
    shearDomains_
    (
        mesh, thickness, smoothed ? domainKind::edge : domainKind::triangle
    )
{
    forAll(mesh.elements, elementi)
    {
        if (!(volumes_[elementi] > 0))
        {
            FatalErrorInFunction
                << "Element " << elementi << " with nodes "
                << mesh.elements[elementi]
                << " is not positively oriented" << exit(FatalError);
        }
    }
}


// ************************************************************************* //
