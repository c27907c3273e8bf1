// SPDX-License-Identifier: GPL-3.0-or-later

#include "polyDataSeries.H"
#include "OSspecific.H"
#include "stringOps.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::polyDataSeries::polyDataSeries
(
    const fileName& folder,
    const word& name,
    const bool binary
)
:
    folder_(folder),
    name_(name),
    binary_(binary)
{
    for (const fileName& file : readDir(folder_, fileName::FILE, false))
    {
        if (file.startsWith(name_ + "_") && file.hasExt("vtp"))
        {
            rm(folder_/file);
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::polyDataSeries::write(const polyData& data, const scalar time)
{
    char number[16];
    std::snprintf(number, sizeof(number), "%06d", int(series_.size()));
    const fileName file(name_ + "_" + number + ".vtp");

    data.write(folder_/file, time, binary_);
    series_.append(time, file);
    series_.write(folder_/(name_ + ".vtp"));
}


// ************************************************************************* //
