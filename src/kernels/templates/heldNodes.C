// SPDX-License-Identifier: GPL-3.0-or-later

#include "heldNodes.H"
#include "DynamicList.H"
#include "dictionaryCheck.H"
#include "errorOf.H"
#include "nodesInRegion.H"
#include "openfoamTypes.H"
#include "openfoamVersion.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::heldNodes::heldNodes
(
    const dictionary& dict,
    const UList<point>& points,
    const point& origin,
    const direction nDims
)
{
    const pointField places(inShape(points, origin));
    scalarField springs(points.size(), -1);
    for (const entry& e : dict)
    {
        const dictionary& region = dictOf(dict, e, "region");
        const labelList nodes
        (
            nodesInRegion(region, places, nDims, {"stiffness"})
        );
        const scalar spring =
            region.found("stiffness")
          ? readPositive(region, "stiffness")/nodes.size()
          : 0;
        for (const label nodei : nodes)
        {
            if (springs[nodei] >= 0)
            {
                FatalIOErrorInFunction(region)
                    << "The region of dictionary " << region.name()
                    << " has the node at " << places[nodei]
                    << ", which another region of dictionary " << dict.name()
                    << " holds as well" << exit(FatalIOError);
            }
            springs[nodei] = spring;
        }
    }
    DynamicList<label> nodes;
    DynamicList<scalar> stiffness;
    forAll(springs, nodei)
    {
        if (springs[nodei] >= 0)
        {
            nodes.append(nodei);
            stiffness.append(springs[nodei]);
        }
    }
    nodes_ = nodes;
    stiffness_ = stiffness;
}


Foam::fsi::heldNodes::heldNodes
(
    const dictionary& written,
    const label nNodes
)
{
    if (!written.found("heldNodes"))
    {
        return;
    }
    nodes_ = readEntry<labelList>(written, "heldNodes");
    stiffness_ = readEntry<scalarField>(written, "heldStiffness");
    if
    (
        nodes_.empty() || min(nodes_) < 0 || max(nodes_) >= nNodes
     || stiffness_.size() != nodes_.size() || !(min(stiffness_) >= 0)
    )
    {
        FatalIOErrorInFunction(written)
            << "Entries 'heldNodes' and 'heldStiffness' in dictionary "
            << written.name() << " must be labels of the " << nNodes
            << " nodes, and as many springs >= 0" << exit(FatalIOError);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::labelList Foam::fsi::heldNodes::clamped() const
{
    DynamicList<label> found;
    forAll(nodes_, i)
    {
        if (stiffness_[i] == 0)
        {
            found.append(nodes_[i]);
        }
    }
    return labelList(found);
}


Foam::scalarField Foam::fsi::heldNodes::masses
(
    const scalar dt,
    const scalar clampedMass
) const
{
    scalarField added(sqr(dt)*stiffness_);
    forAll(added, i)
    {
        added[i] = stiffness_[i] == 0 ? clampedMass : added[i];
    }
    return added;
}


void Foam::fsi::heldNodes::write(Ostream& os) const
{
    if (!empty())
    {
        putList(os, "heldNodes", nodes_);
        putList(os, "heldStiffness", stiffness_);
    }
}


// ************************************************************************* //
