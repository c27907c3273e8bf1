// SPDX-License-Identifier: GPL-3.0-or-later

#include "shapeClasses.H"
#include "dictionaryCheck.H"
#include "primitiveEntry.H"
#include "randomNumbers.H"
#include "readBetween.H"
#include "valueSpread.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::shapeClasses::shapeClasses(const dictionary& dict)
:
    dict_(dict)
{
    const dictionary& spread = dict.subDict("distribution");
    dict_.remove("distribution");
    const label n = readBetween(spread, "classes", 10, 1, 1000);
    randomNumbers random(spread.lookupOrDefault<label>("seed", 1));
    sizes_.setSize(n, scalar(1));

    const dictionary& material = dict.subDict("material");
    wordList known({"classes", "seed", "size"});
    for (const entry& e : material)
    {
        if (!e.isDict() && e.keyword() != "type")
        {
            known.append(e.keyword());
        }
    }
    checkKeys(spread, known);
    label nSpread = 0;
    for (const entry& e : spread)
    {
        const word key(e.keyword());
        if (key == "classes" || key == "seed")
        {
            continue;
        }
        if (!e.isDict())
        {
            FatalIOErrorInFunction(spread)
                << "Entry '" << key << "' in dictionary " << spread.name()
                << " must be a dictionary, for instance { type uniform; min 1;"
                << " max 2; }" << exit(FatalIOError);
        }
        scalarField values(valueSpread(e.dict(), n));
        for (label i = 0; i < n - 1 && nSpread > 0; ++i)
        {
            Swap(values[i], values[random.between(i, n - 1)]);
        }
        ++nSpread;
        if (key == "size")
        {
            sizes_ = values;
        }
        else
        {
            readPositive(material, key);
            keys_.append(key);
            values_.append(values);
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::dictionary Foam::fsi::shapeClasses::dictOf(const label classi) const
{
    dictionary dict(dict_);
    forAll(keys_, i)
    {
        // As a number: a text would have six digits
        dict.subDict("material").set
        (
            new primitiveEntry(keys_[i], token(values_[i][classi]))
        );
    }
    return dict;
}


// ************************************************************************* //
