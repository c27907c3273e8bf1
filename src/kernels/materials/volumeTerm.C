// SPDX-License-Identifier: GPL-3.0-or-later

#include "volumeTerm.H"
#include "error.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- Volumes of the elements; fatal for one that is not positively oriented
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


//- 0 to n - 1
static labelList inOrder(const label n)
{
    labelList result(n);
    forAll(result, i)
    {
        result[i] = i;
    }
    return result;
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::volumeTerm::volumeTerm
(
    const shapeMesh& mesh,
    const scalar thickness,
    const scalar areaStiffness,
    const scalar shearModulus,
    const strainDomains::kind volumeDomains,
    const strainDomains::kind shearDomains
)
:
    stiffness_
    (
        mesh.nDims() == 3 ? areaStiffness + 2*shearModulus/3 : areaStiffness
    ),
    shearPart_(mesh.nDims() == 3 ? shearModulus/max(stiffness_, VSMALL) : 0),
    volumes_(checkedVolumes(mesh, thickness)),
    volumeDomains_(mesh, thickness, volumeDomains),
    shearDomains_(mesh, thickness, shearDomains),
    shearMatrix_(shearDomains_, inOrder(mesh.points.size()))
{}


// ************************************************************************* //
