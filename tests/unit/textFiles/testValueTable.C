// SPDX-License-Identifier: GPL-3.0-or-later

#include "dictionary.H"
#include "error.H"
#include "OSspecific.H"
#include "valueTable.H"

#include <fstream>
#include <gtest/gtest.h>

using namespace Foam;
using namespace Foam::fsi;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Does something with the table of a text in a file, of a name that OpenFOAM
//  does not read
template<class Action>
void withTable
(
    const std::string& text,
    const wordList& columns,
    const Action& action
)
{
    // Gone at the end, whatever the action throws
    struct ownFile
    {
        const std::string name;
        ~ownFile() { ::remove(name.c_str()); }
    };
    const ownFile own{"the values \xc3\xa4.csv"};
    std::ofstream(own.name, std::ios::binary) << text;
    dictionary dict;
    dict.add(word("file"), string(own.name));
    const caseFile file(dict, "file");
    action(valueTable(file, columns));
}


//- x and y of all rows, one after the other
std::vector<scalar> numbersOf
(
    const std::string& text,
    const wordList& columns = wordList()
)
{
    std::vector<scalar> values;
    withTable(text, columns, [&](const valueTable& table)
    {
        for (label i = 0; i < table.size(); ++i)
        {
            values.push_back(table.number(i, "x"));
            values.push_back(table.number(i, "y"));
        }
    });
    return values;
}


//- The message of the error that the text gives
std::string errorOf
(
    const std::string& text,
    const wordList& columns = wordList()
)
{
    try
    {
        numbersOf(text, columns);
    }
    catch (const Foam::IOerror& error)
    {
        return error.message();
    }
    return "";
}


void expectError
(
    const std::string& text,
    const std::vector<std::string>& parts,
    const wordList& columns = wordList()
)
{
    const std::string error(errorOf(text, columns));
    for (const std::string& part : parts)
    {
        EXPECT_NE(error.find(part), std::string::npos)
            << part << " in: " << error << " of: " << text;
    }
    EXPECT_NE(error.find("the values"), std::string::npos) << text;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(valueTable, readsWhatSpreadsheetsWrite)
{
    const std::vector<scalar> expected{0.5, -2, 1e-3, 4};
    for
    (
        const std::string text :
        {
            "x,y\n0.5,-2\n1e-3,4\n",
            "x,y\n0.5,-2\n1e-3,4",
            "x,y\r\n0.5,-2\r\n1e-3,4\r\n",
            "x,y\r0.5,-2\r1e-3,4",
            "\xef\xbb\xbfx,y\n0.5,-2\n1e-3,4\n",
            "y,x\n-2,0.5\n4,1e-3\n",
            "x;y\n0.5;-2\n1e-3;4\n",
            "x\ty\n0.5\t-2\n1e-3\t4\n",
            "x y\n 0.5  -2\n1e-3 4 \n",
            "\"x\", \"y\"\n\"0.5\", -2\n 1e-3 ,4\n",
            "# of 2026; by hand\n\nx,y\n\n0.5,-2 # first\n   \n1e-3,+4.\n\n",
            "x,name,y,\n0.5,\"a, b\",-2,\n1e-3,c,4,,\n"
        }
    )
    {
        EXPECT_EQ(numbersOf(text), expected) << text;
    }
}


TEST(valueTable, readsPointsWithoutNames)
{
    const std::vector<scalar> expected{0.5, -2, 1e-3, 4};
    for
    (
        const std::string text :
        {
            "0.5,-2\n1e-3,4",
            "0.5 -2\n1e-3 4\n",
            "0.5;-2;7\n1e-3;4;8\n",
            "NACA 0012 AIRFOIL\n0.5 -2\n1e-3 4\n",
            "outline, of a wing\n0.5 -2\n1e-3 4\n\n",
            "2\n0.5 -2\n1e-3 4\n",
            "a wing\ny,x\n-2,0.5\n4,1e-3\n"
        }
    )
    {
        EXPECT_EQ(numbersOf(text, {"x", "y"}), expected) << text;
    }
    expectError("0.5,-2\nx,y\n", {"line 2, column x", "'x'"}, {"x", "y"});
    expectError("abc,-2\n1,2\n", {"line 1, column x", "'abc'"}, {"x", "y"});
    expectError("3\n0 0\n1 0\n", {"line 1", "3 rows", "are 2"}, {"x", "y"});
    expectError("0,1\n0\n", {"line 2", "1 values, not 2"}, {"x", "y"});
}


TEST(valueTable, namesLineAndColumnOfWhatIsWrong)
{
    const std::string head("x,y,z\n\n1,2,3\n");
    expectError(head + "4,,6\n", {"line 4, column y", "missing"});
    expectError(head + ",5,6\n", {"line 4, column x", "missing"});
    expectError(head + "4,5,\n", {"line 4", "2 values, not 3"});
    expectError(head + "4,5,6,7", {"line 4", "4 values, not 3"});
    expectError(head + "4,\"5,6\n", {"line 4", "quote"});
    for
    (
        const std::string wrong :
        {"1e400", "nan", "inf", "-1e15", "0x10", "1.2.3", "5m", "1e", "--1"}
    )
    {
        expectError
        (
            head + "4," + wrong + ",6",
            {"line 4, column y", "'" + wrong + "'", "1e15"}
        );
    }
    expectError("x;y\n0,5;2\n", {"line 2, column x", "'0,5'"});
    expectError(std::string("x,\0y\n1,2\n", 9), {"plain text"});
    expectError("", {"empty"});
}


// ************************************************************************* //
