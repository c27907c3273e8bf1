// SPDX-License-Identifier: GPL-3.0-or-later

#include <gtest/gtest.h>

#include "population/someObjects.H"
#include "diskNote.H"
#include "needsThrownErrors.H"
#include "writtenFiles.H"

using namespace Foam;
using Foam::fsi::boxMesh;

namespace
{

//- The message of a time whose writing ends in an error
std::string messageOf(const std::function<void()>& wrong)
{
    boxMesh box(labelVector(8, 8, 1), 2);
    autoPtr<Time> time = someObjects::makeTime(box, "ascii");
    return someObjects::errorText
    (
        [&]() { fsi::writtenFiles::write(*time, wrong); }
    );
}


//- Is a text in another one?
bool isPart(const std::string& text, const std::string& of)
{
    return of.find(text) != std::string::npos;
}

} // End namespace


TEST(WrittenFiles, anErrorIsToldAsItIs)
{
    NEEDS_THROWN_ERRORS
    const std::string text = messageOf
    (
        []()
        {
            FatalErrorInFunction << "the sums differ" << exit(FatalError);
        }
    );
    EXPECT_TRUE(isPart("the sums differ", text)) << text;
    EXPECT_TRUE(isPart("complete", text)) << text;
    EXPECT_FALSE(isPart("disk", text)) << text;
    EXPECT_FALSE(isPart("takes no more", text)) << text;
}


TEST(WrittenFiles, anErrorOfADictionaryNamesIt)
{
    NEEDS_THROWN_ERRORS
    const std::string text = messageOf
    (
        []()
        {
            dictionary dict("system/someDict");
            FatalIOErrorInFunction(dict) << "no entry" << exit(FatalIOError);
        }
    );
    EXPECT_TRUE(isPart("no entry (system/someDict", text)) << text;
    EXPECT_FALSE(isPart("disk", text)) << text;
}


TEST(DiskNote, isTheReasonOfTheSystem)
{
    boxMesh box(labelVector(8, 8, 1), 2);
    EXPECT_EQ(fsi::diskNote(box.casePath()), "");
    const fileName nowhere(box.casePath()/"nowhere");
    const std::string text = fsi::diskNote(nowhere);
    EXPECT_TRUE(isPart(nowhere + " takes no more data: No such", text)) << text;
}


// ************************************************************************* //
