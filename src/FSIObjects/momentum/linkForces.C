// SPDX-License-Identifier: GPL-3.0-or-later

#include "linkForces.H"
#include "sumOverRanks.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

typedef viscousResponse::copyLink copyLink;

//- Give every rank the links of all ranks, in the order of the ranks
static void gatherLinks(std::vector<std::vector<copyLink>>& links)
{
    if (!severalRanks())
    {
        return;
    }

    DynamicList<scalar> packed;
    for (std::size_t objecti = 0; objecti < links.size(); ++objecti)
    {
        for (const copyLink& link : links[objecti])
        {
            packed.append(scalar(objecti));
            packed.append(link.coefficient);
            forAll(link.nodes, i)
            {
                packed.append(scalar(link.nodes[i]));
                packed.append(link.weights[i]);
            }
        }
        links[objecti].clear();
    }
    const List<scalarList> ranks(gatherOverRanks(scalarList(packed)));

    const label width = 2 + 2*copyLink().nodes.size();
    for (const scalarList& values : ranks)
    {
        for (label start = 0; start < values.size(); start += width)
        {
            copyLink link;
            link.coefficient = values[start + 1];
            forAll(link.nodes, i)
            {
                link.nodes[i] = label(round(values[start + 2 + 2*i]));
                link.weights[i] = values[start + 3 + 2*i];
            }
            links[std::size_t(round(values[start]))].push_back(link);
        }
    }
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
    links.resize(bodies.size());
    for (auto& ofObject : links)
    {
        ofObject.clear();
    }
    for (const wallLink& link : geometry.wallLinks())
    {
        const label objecti = link.place.object;
        viscousResponse::copyLink c;
        c.coefficient = viscosity*link.conductance;
        forAll(c.nodes, i)
        {
            const bool used =
                i < link.place.nodes.size() && link.place.nodes[i] >= 0;
            c.nodes[i] = used ? link.place.nodes[i] - start[objecti] : -1;
            c.weights[i] = used ? link.place.weights[i] : 0;
        }
        links[objecti].push_back(c);
    }
    gatherLinks(links);
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
