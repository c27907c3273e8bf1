// SPDX-License-Identifier: GPL-3.0-or-later

#include "dictionaryCheck.H"
#include "IFstream.H"
#include "IStringStream.H"
#include "misspelling.H"
#include "OSspecific.H"
#include "userVariables.H"

#include <fstream>
#include <gtest/gtest.h>

using namespace Foam;
using namespace Foam::fsi;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

void write(const fileName& file, const char* text)
{
    std::ofstream os(file);
    os << text;
}


//- The dictionary of a file with this text
struct dictionaryFile
{
    const fileName path;

    explicit dictionaryFile(const char* text)
    :
        path("userVariablesDict")
    {
        write(path, text);
    }

    ~dictionaryFile() { rm(path); }

    dictionary read() const
    {
        IFstream is(path);
        return dictionary(is);
    }
};

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(userVariables, areFoundInAllTheirForms)
{
    write("userVariablesPart", "d 1; q { e $d; }");
    const dictionaryFile file
    (
        "#include \"userVariablesPart\"\n"
        "a 1; b 2; c { x 3; }  s \"a // $quoted\"; // $line\n"
        "/* $block */ v $a; w ${b}; z ($c.x $:d $..up 1);\n"
    );
    const wordHashSet used(userVariables::usedIn(file.path));
    for (const char* name : {"a", "b", "c", "x", "d", "up", "quoted"})
    {
        EXPECT_TRUE(used.found(name)) << name;
    }
    for (const char* name : {"v", "w", "e", "line", "block"})
    {
        EXPECT_FALSE(used.found(name)) << name;
    }
    rm("userVariablesPart");
}


TEST(userVariables, areKnownInAWrittenState)
{
    // Where no $ tells that they were used
    dictionary part(dictionary(IStringStream("mu 3; E 3; density 1;")()));
    EXPECT_THROW(checkKeys(part, {"E", "density"}), Foam::IOerror);
    part.name() = "/case/0.5/uniform/fsiObjects/disc.material";
    checkKeys(part, {"E", "density"});
}


TEST(userVariables, copiesMayHaveMoreThanIsNeeded)
{
    const dictionaryFile file
    (
        "steel { density 1; E 2; densitty 3; }"
        "part { $steel; } other { F 3; }"
    );
    const dictionary dict(file.read());
    EXPECT_THROW(checkKeys(dict.subDict("part"), {"density"}), Foam::IOerror);
    checkKeys(dict.subDict("part"), {"density", "densitty"});
    EXPECT_THROW(checkKeys(dict.subDict("other"), {"x"}), Foam::IOerror);
}


TEST(userVariables, ofAnotherNameAreNoEntries)
{
    const dictionaryFile file("part { mu 3; E $mu; densty 1; }");
    const dictionary dict(file.read());
    EXPECT_THROW
    (
        checkKeys(dict.subDict("part"), {"E", "density"}), Foam::IOerror
    );
}


TEST(userVariables, ofAFileMayBeUnusedButNotLikeAnEntry)
{
    const wordList known({"gravity", "wall"});
    {
        const dictionaryFile file("rho 3; g { x 1; } wall slip;");
        userVariables::checkFileKeys(file.read(), known);
    }
    const dictionaryFile file("gravty 3;");
    EXPECT_THROW
    (
        userVariables::checkFileKeys(file.read(), known), Foam::IOerror
    );
    const dictionaryFile old("wall slip; convection upwind;");
    userVariables::checkFileKeys(old.read(), known);
    EXPECT_THROW
    (
        userVariables::checkFileKeys(old.read(), known, {"convection"}),
        Foam::IOerror
    );
}


TEST(userVariables, knowWhatIsMeant)
{
    const wordList known({"gravity", "wall", "fluidDensity", "coupling"});
    EXPECT_EQ(meant("Gravity", known), "gravity");
    EXPECT_EQ(meant("gravtiy", known), "gravity");
    EXPECT_EQ(meant("walls", known), "wall");
    EXPECT_EQ(meant("fluidDensiti", known), "fluidDensity");
    for (const char* other : {"rho", "E", "g", "fluidVelocity", "radius", "nu"})
    {
        EXPECT_EQ(meant(other, known), "") << other;
    }
}


TEST(userVariables, patternsMustMatchAnEntry)
{
    const dictionaryFile file("\"(E|density)\" 3;");
    checkKeys(file.read(), {"E", "density"});
    const dictionaryFile other("\"rod.*\" 3;");
    EXPECT_THROW(checkKeys(other.read(), {"E", "density"}), Foam::IOerror);
}


// ************************************************************************* //
