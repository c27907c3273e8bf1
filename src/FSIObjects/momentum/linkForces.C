// SPDX-License-Identifier: GPL-3.0-or-later

#include "linkForces.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

typedef viscousResponse::copyLink copyLink;

//- A link as numbers
static void pack(const copyLink& link, DynamicList<scalar>& numbers)
{
    numbers.append(link.coefficient);
    forAll(link.nodes, i)
    {
        numbers.append(link.nodes[i]);
        numbers.append(link.weights[i]);
    }
}


//- Links from numbers
static std::vector<copyLink> unpacked(const UList<scalar>& numbers)
{
    const label width = 1 + 2*copyLink().nodes.size();
    std::vector<copyLink> links(numbers.size()/width);
    const scalar* next = numbers.cdata();
    for (copyLink& link : links)
    {
        link.coefficient = *next++;
        forAll(link.nodes, i)
        {
            link.nodes[i] = label(*next++);
            link.weights[i] = *next++;
        }
    }
    return links;
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::fsi::setCopyLinks
(
    const population& bodies,
    const interfaceGeometry& geometry,
    const scalar viscosity,
    viscousResponse::copyLinks& links
)
{
    const labelList& start = bodies.surfaces().pointStart();
    List<DynamicList<scalar>> numbers(bodies.nHeld());
    const auto add = [&](const surfacePlace& place, const scalar conductance)
    {
        copyLink c;
        c.coefficient = viscosity*conductance;
        forAll(c.nodes, i)
        {
            const bool used = i < place.nodes.size() && place.nodes[i] >= 0;
            c.nodes[i] = used ? place.nodes[i] - start[place.object] : -1;
            c.weights[i] = used ? place.weights[i] : 0;
        }
        pack(c, numbers[place.object]);
    };
    for (const wallLink& link : geometry.wallLinks())
    {
        add(link.place, link.conductance);
    }
    for (const filmLink& link : geometry.betweenSurfaces())
    {
        for (const filmSide& side : link.sides)
        {
            if (!side.isWall())
            {
                add(side.place, 2*link.conductance);
            }
        }
    }
    bodies.ranks().collect(numbers);
    links.resize(bodies.size());
    for (label objecti = 0; objecti < bodies.size(); ++objecti)
    {
        links[objecti] = unpacked(numbers[objecti]);
    }
}


Foam::scalarField Foam::fsi::meanViscosities
(
    const population& bodies,
    const interfaceGeometry& geometry
)
{
    const surfaceSet& surfaces = bodies.surfaces();
    scalarField links(surfaces.points().size(), Zero), viscosities(links);
    for (const wallLink& link : geometry.wallLinks())
    {
        link.place.spread(links, 1.0);
        link.place.spread(viscosities, link.viscosity);
    }
    typedef objectRanks::values values;
    bodies.ranks().collect
    (
        {values::ofWalls(links), values::ofWalls(viscosities)}
    );
    scalarField mean(bodies.size(), 1.0);
    forAll(mean, objecti)
    {
        const label start = surfaces.pointStart()[objecti];
        const label n = surfaces.pointStart()[objecti + 1] - start;
        const scalar all = sum(SubField<scalar>(links, n, start));
        if (all > 0)
        {
            mean[objecti] = sum(SubField<scalar>(viscosities, n, start))/all;
        }
    }
    return mean;
}


void Foam::fsi::addLinkForce
(
    const interfaceGeometry& geometry,
    const scalar viscosity,
    const volVectorField& U,
    const vectorField& v,
    partialForces& force
)
{
    for (const wallLink& link : geometry.wallLinks())
    {
        const vector slip(U[link.cell] - link.place.interpolate(v));
        link.place.spread(force.mine(), viscosity*link.conductance*slip);
    }
}


// ************************************************************************* //
