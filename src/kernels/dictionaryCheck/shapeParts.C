// SPDX-License-Identifier: GPL-3.0-or-later

#include "shapeParts.H"
#include "dictionaryCheck.H"
#include "errorOf.H"
#include "openfoamVersion.H"
#include "Tuple2.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- Is a shape NAME_1, NAME_2.. one of the classes or pieces of a shape NAME?
static bool isPiece(const word& shape, const word& name)
{
    const std::size_t n = name.size();
    return
        shape.size() > n + 1 && shape.compare(0, n, name) == 0
     && shape[n] == '_'
     && shape.find_first_not_of("0123456789", n + 1) == std::string::npos;
}


//- Names with their parts
static List<Tuple2<word, scalar>> readParts(const dictionary& dict)
{
    typedef List<Tuple2<word, scalar>> parts;
    if (dict.found("shape") == dict.found("shapes"))
    {
        FatalIOErrorInFunction(dict)
            << "Dictionary " << dict.name() << " needs either the entry 'shape'"
            << " or the entry 'shapes'" << exit(FatalIOError);
    }
    if (dict.found("shape"))
    {
        return parts(1, Tuple2<word, scalar>(getEntry<word>(dict, "shape"), 1));
    }
    const parts given(readEntry<parts>(dict, "shapes"));
    for (const Tuple2<word, scalar>& each : given)
    {
        if (!(each.second() > 0 && each.second() < GREAT))
        {
            FatalIOErrorInFunction(dict)
                << "Entry 'shapes' in dictionary " << dict.name() << ": the"
                << " part of shape " << each.first() << " is " << each.second()
                << " but must be > 0" << exit(FatalIOError);
        }
    }
    if (given.empty())
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'shapes' in dictionary " << dict.name() << " is empty"
            << exit(FatalIOError);
    }
    return given;
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::shapeParts::shapeParts
(
    const dictionary& dict,
    const wordList& known,
    const string& hint
)
{
    scalar total = 0;
    for (const Tuple2<word, scalar>& each : readParts(dict))
    {
        const labelList named(shapeParts::named(each.first(), known));
        if (named.empty())
        {
            const word key(dict.found("shape") ? "shape" : "shapes");
            fail(dict, key, each.first(), known, hint);
        }
        for (const label i : named)
        {
            shapes.append(i);
            parts.append(each.second()/named.size());
        }
        total += each.second();
    }
    for (scalar& part : parts)
    {
        part /= total;
    }
}


// * * * * * * * * * * * * * Static Member Functions * * * * * * * * * * * * //

Foam::labelList Foam::fsi::shapeParts::named
(
    const word& name,
    const wordList& known
)
{
    const label shapei = indexOf(known, name);
    if (shapei >= 0)
    {
        return labelList(1, shapei);
    }
    DynamicList<label> shapes;
    forAll(known, i)
    {
        if (isPiece(known[i], name))
        {
            shapes.append(i);
        }
    }
    return labelList(shapes);
}


void Foam::fsi::shapeParts::fail
(
    const dictionary& dict,
    const word& key,
    const word& name,
    const wordList& known,
    const string& hint
)
{
    FatalIOErrorInFunction(dict)
        << "Unknown shape '" << name << "' in entry '" << key
        << "' of dictionary " << dict.name() << nl
        << "Valid shapes are " << flatOutput(known) << hint.c_str()
        << exit(FatalIOError);
}


// ************************************************************************* //
