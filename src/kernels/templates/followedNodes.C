// SPDX-License-Identifier: GPL-3.0-or-later

#include "followedNodes.H"
#include "dictionaryCheck.H"
#include "errorOf.H"
#include "nodesInRegion.H"
#include "openfoamTypes.H"
#include "openfoamVersion.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::followedNodes::followedNodes
(
    const dictionary& dict,
    const UList<point>& points,
    const point& origin,
    const direction nDims
)
:
    names_(dict.toc()),
    nodes_(names_.size())
{
    const pointField places(inShape(points, origin));
    label placei = 0;
    for (const entry& e : dict)
    {
        nodes_[placei++] =
            nodesInRegion(dictOf(dict, e, "region"), places, nDims);
    }
}


Foam::fsi::followedNodes::followedNodes
(
    const dictionary& written,
    const label nNodes
)
{
    const dictionary& dict = written.subOrEmptyDict("followedNodes");
    names_ = dict.toc();
    nodes_.setSize(names_.size());
    forAll(names_, placei)
    {
        labelList& nodes = nodes_[placei];
        nodes = readEntry<labelList>(dict, names_[placei]);
        if (nodes.empty() || min(nodes) < 0 || max(nodes) >= nNodes)
        {
            FatalIOErrorInFunction(dict)
                << "Entry '" << names_[placei] << "' in dictionary "
                << dict.name() << " must be labels of the " << nNodes
                << " nodes of the surface" << exit(FatalIOError);
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::vector Foam::fsi::followedNodes::mean
(
    const label placei,
    const UList<vector>& values
) const
{
    vector sum(Zero);
    for (const label nodei : nodes_[placei])
    {
        sum += values[nodei];
    }
    return sum/nodes_[placei].size();
}


void Foam::fsi::followedNodes::write(Ostream& os) const
{
    if (names_.empty())
    {
        return;
    }
    dictionary places;
    forAll(names_, placei)
    {
        places.add(names_[placei], nodes_[placei]);
    }
    putDict(os, "followedNodes", places);
}


// ************************************************************************* //
