// SPDX-License-Identifier: GPL-3.0-or-later

#include "placement.H"

// * * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * //

void Foam::fsi::placement::insertAll
(
    packing& space,
    const UList<placedObject>& objects,
    const word& key,
    const fileName& file
) const
{
    const label maxNamed = 10;
    DynamicList<string> refused;

    for (const placedObject& object : objects)
    {
        const closedSurface candidate = space.placed(object);
        const label other = space.findConflict(object, minimumGap_);
        const label objecti = space.insert(object);

        if (!space.inDomain(object, candidate, wallGap_))
        {
            refused.append
            (
                space.description(objecti)
              + " is not in the domain with wallGap "
              + Foam::name(wallGap_)
            );
        }
        if (other >= 0)
        {
            const scalar gap = space.distance(candidate, other);
            refused.append
            (
                space.description(objecti)
              + (gap > 0 ? " is nearer than minimumGap to " : " overlaps ")
              + space.description(other)
              + (gap > 0 ? ", distance " + Foam::name(gap) : string())
            );
        }
    }

    if (refused.size())
    {
        OSstream& os = FatalIOErrorInFunction(dict_);
        os  << "Entry '" << key << "' of placement " << name_
            << (file.empty() ? "" : " (file " + file + ")").c_str()
            << " places objects where they cannot be:" << nl;
        for (label i = 0; i < min(refused.size(), maxNamed); ++i)
        {
            os  << "    " << refused[i].c_str() << nl;
        }
        if (refused.size() > maxNamed)
        {
            os  << "    and " << refused.size() - maxNamed << " more" << nl;
        }
        os  << exit(FatalIOError);
    }
}


// ************************************************************************* //
