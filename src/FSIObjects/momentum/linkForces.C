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
    for (const wallLink& link : geometry.wallLinks())
    {
        const label objecti = link.place.object;
        copyLink c;
        c.coefficient = viscosity*link.conductance;
        forAll(c.nodes, i)
        {
            const bool used =
                i < link.place.nodes.size() && link.place.nodes[i] >= 0;
            c.nodes[i] = used ? link.place.nodes[i] - start[objecti] : -1;
            c.weights[i] = used ? link.place.weights[i] : 0;
        }
        pack(c, numbers[objecti]);
    }
    bodies.ranks().collect(numbers);
    links.resize(bodies.size());
    for (label objecti = 0; objecti < bodies.size(); ++objecti)
    {
        links[objecti] = unpacked(numbers[objecti]);
    }
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
