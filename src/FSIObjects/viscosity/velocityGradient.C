// SPDX-License-Identifier: GPL-3.0-or-later

#include "velocityGradient.H"
#include "extrapolatedCalculatedFvPatchFields.H"
#include "openfoamVersion.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;
using namespace Foam::fsi;

//- Sums the slopes on both sides of cells
class slopeSum
{
    const interfaceGeometry& geometry_;
    const cartesianMesh& grid_;

    //- Distance of what is on each side of each cell, in cells
    List<FixedList<scalar, 6>> away_;

public:

    slopeSum(const interfaceGeometry& geometry, const volVectorField& U)
    :
        geometry_(geometry),
        grid_(geometry.grid()),
        away_(U.size(), FixedList<scalar, 6>(scalar(1)))
    {
        for (const wallLink& link : geometry.wallLinks())
        {
            away_[link.cell][2*link.dir + link.upwards] = link.wallDistance;
        }
        for (const fvPatchVectorField& pU : U.boundaryField())
        {
            const labelUList& cells = pU.patch().faceCells();
            const bool given = !pU.coupled() && pU.fixesValue();
            for (label i = 0; i < pU.size() && given; ++i)
            {
                const label facei = pU.patch().start() + i;
                const direction d = grid_.faceDirection(facei);
                away_[cells[i]][2*d + grid_.faceAlong(facei)] = 0.5;
            }
        }
    }

    //- Add a slope along the axis
    void add
    (
        volTensorField& gradient,
        const label celli,
        const direction dir,
        const bool upwards,
        const vector& slope
    ) const
    {
        const FixedList<scalar, 6>& away = away_[celli];
        const scalar other = away[2*dir + !upwards];
        const scalar weight = other/(other + away[2*dir + upwards]);
        for (direction d = 0; d < 3; ++d)
        {
            gradient[celli][3*dir + d] += weight*slope[d];
        }
    }

    //- Add the slopes at faces between two fluid cells of this rank
    void addInside(const volVectorField& U, volTensorField& gradient) const
    {
        const boolList& fluid = geometry_.fluidCell();
        const labelUList& own = U.mesh().owner();
        const labelUList& nei = U.mesh().neighbour();
        const scalar perLength = 1/grid_.spacing();
        forAll(nei, facei)
        {
            const label a = own[facei], b = nei[facei];
            if (fluid[a] && fluid[b])
            {
                const bool along = grid_.faceAlong(facei);
                const direction dir = grid_.faceDirection(facei);
                const scalar scale = along ? perLength : -perLength;
                const vector slope(scale*(U[b] - U[a]));
                add(gradient, a, dir, along, slope);
                add(gradient, b, dir, !along, slope);
            }
        }
    }

    //- Slopes along the axis at the faces of a patch
    vectorField patchSlope(const fvPatchVectorField& pU) const
    {
        const scalar perLength = 1/grid_.spacing();
        vectorField slope(pU.size());
        if (pU.coupled())
        {
            slope = pU.patchNeighbourField();
            slope = perLength*(slope - pU.patchInternalField());
        }
        else
        {
            slope = pU.snGrad();
        }
        forAll(slope, i)
        {
            slope[i] *= grid_.faceAlong(pU.patch().start() + i) ? 1 : -1;
        }
        return slope;
    }

    //- Add the slopes at the faces of a patch
    void addPatch(const fvPatchVectorField& pU, volTensorField& gradient) const
    {
        const label start = pU.patch().start();
        const label first = start - grid_.mesh().nInternalFaces();
        const labelUList& cells = pU.patch().faceCells();
        const vectorField slope(patchSlope(pU));
        forAll(slope, i)
        {
            if
            (
                geometry_.fluidCell()[cells[i]]
             && geometry_.fluidAcross()[first + i]
            )
            {
                add
                (
                    gradient, cells[i], grid_.faceDirection(start + i),
                    grid_.faceAlong(start + i), slope[i]
                );
            }
        }
    }
};


//- Slope from a cell to the wall of a link
vector wallSlope
(
    const interfaceGeometry& geometry,
    const wallLink& link,
    const vector& U,
    const vectorField& walls
)
{
    const scalar distance = link.wallDistance*geometry.grid().spacing();
    return
        (link.place.interpolate(walls) - U)
       /(link.upwards ? distance : -distance);
}


//- Set the derivative along an axis
void setRow(tensor& gradient, const direction dir, const vector& slope)
{
    for (direction d = 0; d < 3; ++d)
    {
        gradient[3*dir + d] = slope[d];
    }
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::tmp<Foam::volTensorField> Foam::fsi::velocityGradient
(
    const interfaceGeometry& geometry,
    const volVectorField& U,
    const vectorField& walls
)
{
    const fvMesh& mesh = U.mesh();
    auto tgradient = newTmp<volTensorField>
    (
        IOobject("gradient", nameOf(mesh.time()), mesh),
        mesh,
        dimensionedTensor(dimless/dimTime, Zero),
        extrapolatedCalculatedFvPatchTensorField::typeName
    );
    volTensorField& gradient = tgradient.ref();
    slopeSum sides(geometry, U);
    sides.addInside(U, gradient);
    for (const fvPatchVectorField& pU : U.boundaryField())
    {
        sides.addPatch(pU, gradient);
    }
    for (const wallLink& link : geometry.wallLinks())
    {
        sides.add
        (
            gradient, link.cell, link.dir, link.upwards,
            wallSlope(geometry, link, U[link.cell], walls)
        );
    }

    gradient.correctBoundaryConditions();
    forAll(U.boundaryField(), patchi)
    {
        const fvPatchVectorField& pU = U.boundaryField()[patchi];
        if (pU.size() && !pU.coupled())
        {
            fvPatchTensorField& pg = gradient.boundaryFieldRef()[patchi];
            const vectorField slope(sides.patchSlope(pU));
            const label start = pU.patch().start();
            forAll(slope, i)
            {
                const direction d = geometry.grid().faceDirection(start + i);
                setRow(pg[i], d, slope[i]);
            }
        }
    }
    return tgradient;
}


Foam::tensor Foam::fsi::gradientAtWall
(
    const interfaceGeometry& geometry,
    const wallLink& link,
    const tensor& gradient,
    const vector& U,
    const vectorField& walls
)
{
    tensor atWall(gradient);
    setRow(atWall, link.dir, wallSlope(geometry, link, U, walls));
    return atWall;
}


// ************************************************************************* //
