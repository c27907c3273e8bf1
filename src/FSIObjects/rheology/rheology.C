// SPDX-License-Identifier: GPL-3.0-or-later

#include "rheology.H"
#include "fsiObjects.H"
#include "objectWriter.H"
#include "openfoamMesh.H"
#include "sumOverRanks.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::rheology::measureSides(tensor& strain, vector& force) const
{
    const volVectorField& U =
        objects_.grid().mesh().lookupObject<volVectorField>("U");
    strain = Zero;
    force = Zero;
    forAll(U.boundaryField(), patchi)
    {
        const fvPatchVectorField& side = U.boundaryField()[patchi];
        if (side.coupled() || side.empty())
        {
            continue;
        }
        const vectorField gradient(side.snGrad());
        const vectorField& areas = side.patch().Sf();
        forAll(side, facei)
        {
            const vector& area = areas[facei];
            strain += area*side[facei];
            force += sign(area[gradient_])*mag(area)*gradient[facei];
        }
    }
    force *= objects_.fluid().dynamicViscosity();
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::rheology::rheology(const fsiObjects& objects)
:
    objects_(objects),
    gradient_(0)
{
    label nWalls = 0;
    bool closed = true;
    if (objects.fluid().viscosity <= 0)
    {
        FatalIOErrorInFunction(objects.properties())
            << "Entry 'rheology' of 'output' in "
            << objects.properties().name() << " is for a Newtonian fluid, whose"
            << " viscosity nu is in constant/transportProperties"
            << exit(FatalIOError);
    }
    for (direction d = 0; d < objects.grid().nDims(); ++d)
    {
        if
        (
            objects.sides()(d, false) == domainSides::WALL
         && objects.sides()(d, true) == domainSides::WALL
        )
        {
            ++nWalls;
            gradient_ = d;
        }
        else
        {
            closed = closed && objects.images().period()[d] > 0;
        }
    }
    if (nWalls != 1 || !closed)
    {
        FatalIOErrorInFunction(objects.properties())
            << "Entry 'rheology' of 'output' in "
            << objects.properties().name() << " is for a box with two walls"
            << " that face each other, and cyclic sides in all other"
            << " directions" << exit(FatalIOError);
    }
    table_ = objectWriter::newTable
    (
        objects.grid().mesh().time(),
        "rheology",
        {
            "time", "shearRate", "wallStress", "fluidStress", "objectStress",
            "contactStress", "wallViscosity", "viscosity", "N1", "N2",
            "contactN1", "contactN2"
        }
    );
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::rheology::write
(
    const symmTensorField& stresslets,
    const symmTensorField& contactStresses
)
{
    tensor strain;
    vector force;
    measureSides(strain, force);
    List<tensor> sums
    ({
        strain, tensor(sum(stresslets)), tensor(sum(contactStresses)),
        tensor(force, Zero, Zero)
    });
    sumOverRanks(sums);
    if (!table_.valid())
    {
        return;
    }

    const boundBox& box = objects_.sides().bounds();
    const scalar volume = cmptProduct(box.span());
    const scalar area = volume/box.span()[gradient_];
    const direction g = gradient_;
    const tensor G(sums[0]/volume);
    const vector slide(G[3*g], G[3*g + 1], G[3*g + 2]);
    direction f = (g + 1) % 3;
    for (direction d = 0; d < 3; ++d)
    {
        f = d != g && mag(slide[d]) > mag(slide[f]) ? d : f;
    }
    const direction v = 3 - f - g;
    const scalar mu = objects_.fluid().dynamicViscosity();
    const scalar unit = max(mu*mag(slide[f]), VSMALL);

    const tensor contact(sums[2]/volume);
    const tensor all(mu*(G + G.T()) + sums[1]/volume + contact);
    const auto difference = [](const tensor& t, direction a, direction b)
    {
        return t[4*a] - t[4*b];
    };
    const scalar wall = sums[3][f]/(2*area);
    csvTable::rowWriter row(table_());
    row << objects_.grid().mesh().time().value() << slide[f] << wall
        << mu*slide[f] << sums[1][3*g + f]/volume << contact[3*g + f]
        << sign(slide[f])*wall/unit << sign(slide[f])*all[3*g + f]/unit
        << difference(all, f, g) << difference(all, g, v)
        << difference(contact, f, g) << difference(contact, g, v);
}


// ************************************************************************* //
