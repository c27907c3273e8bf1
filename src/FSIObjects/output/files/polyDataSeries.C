// SPDX-License-Identifier: GPL-3.0-or-later

#include "polyDataSeries.H"
#include "openfoamVersion.H"
#include "OSspecific.H"
#include "OFstream.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::polyDataSeries::polyDataSeries
(
    const fileName& folder,
    const word& name
)
:
    folder_(folder),
    name_(name)
{
    for (const fileName& file : filesIn(folder_))
    {
        if (file.find(name_ + "_") == 0 && file.ext() == "vtp")
        {
            rm(folder_/file);
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::polyDataSeries::write(const polyData& data, const scalar time)
{
    char number[16];
    std::snprintf(number, sizeof(number), "%06d", int(times_.size()));
    const fileName file(name_ + "_" + number + ".vtp");

    data.write(folder_/file, time);
    files_.append(file);
    times_.append(time);

    OFstream os(folder_/(name_ + ".vtp.series"));
    os  << "{\n  \"file-series-version\" : \"1.0\",\n  \"files\" : [\n";
    forAll(files_, i)
    {
        os  << "    { \"name\" : \"" << files_[i].c_str() << "\", \"time\" : "
            << times_[i] << " }" << (i + 1 < files_.size() ? "," : "") << nl;
    }
    os  << "  ]\n}\n";
}


// ************************************************************************* //
