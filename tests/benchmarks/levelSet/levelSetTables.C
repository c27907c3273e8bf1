// SPDX-License-Identifier: GPL-3.0-or-later
/*---------------------------------------------------------------------------*\
Program
    levelSetTables

Description
    Prints the measured figures of the level set in doc/choices.md: errors and
    orders of the march, of the extension and of the advection, alignment and
    cost of the rebuilt and the advected level set. Takes some minutes.

Usage
    levelSetTables [TABLE]...

    TABLE: march, reinitialise, extension, advection, alignment, cost or
    triangles.

    Without an argument all tables are printed.
\*---------------------------------------------------------------------------*/

#include "levelSetTables.H"

#include <cstdio>
#include <string>
#include <utility>
#include <vector>

// * * * * * * * * * * * * * * * Main Program  * * * * * * * * * * * * * * * //

int main(int argc, char* argv[])
{
    using namespace Foam;

    const std::vector<std::pair<std::string, void (*)()>> tables
    ({
        {"march", fsi::marchTable},
        {"reinitialise", fsi::reinitialiseTable},
        {"extension", fsi::extensionTable},
        {"advection", fsi::advectionTable},
        {"alignment", fsi::alignmentTable},
        {"cost", fsi::costTable},
        {"triangles", fsi::triangleTable}
    });

    for (const auto& table : tables)
    {
        bool wanted = argc == 1;
        for (int i = 1; i < argc; ++i)
        {
            wanted = wanted || table.first == argv[i];
        }
        if (wanted)
        {
            table.second();
            std::fflush(stdout);
        }
    }
    return 0;
}


// ************************************************************************* //
