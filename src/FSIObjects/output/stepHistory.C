// SPDX-License-Identifier: GPL-3.0-or-later

#include "stepHistory.H"
#include "error.H"
#include "ListOps.H"
#include "openfoamVersion.H"
#include "OSspecific.H"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <sstream>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- The values between the commas of a line
static DynamicList<string> split(const std::string& line)
{
    DynamicList<string> values;
    std::istringstream is(line);
    for (std::string value; std::getline(is, value, ',');)
    {
        values.append(value);
    }
    return values;
}


//- Is the text a number or infinity? (nan is neither)
static bool isNumber(const string& text, scalar& value)
{
    // As strtod, knows inf and nan
    char* end = nullptr;
    value = std::strtod(text.c_str(), &end);
    return !text.empty() && *end == '\0' && !std::isnan(value);
}


//- Names of the folders of the runs, in order of their start
static wordList runs(const fileName& folder)
{
    DynamicList<word> names;
    DynamicList<scalar> starts;
    for (const fileName& name : foldersIn(folder))
    {
        if (isFile(folder/name/"global.csv"))
        {
            names.append(name);
            starts.append(std::strtod(name.c_str(), nullptr));
        }
    }
    return wordList(names, orderOf(starts));
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::stepHistory::stepHistory(const fileName& folder)
:
    folder_(folder)
{
    for (const word& run : runs(folder))
    {
        cut(std::strtod(run.c_str(), nullptr));
        read(folder/run/"global.csv");
    }
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::stepHistory::cut(const scalar time)
{
    if (columns_.empty())
    {
        return;
    }
    const UList<scalar>& times = columns_["time"];
    label n = times.size();
    while (n > 0 && times[n - 1] > time)
    {
        --n;
    }
    for (auto& column : columns_)
    {
        column.resize(n);
    }
}


void Foam::fsi::stepHistory::read(const fileName& file)
{
    std::ifstream is(file);
    std::string line;
    std::getline(is, line);
    const DynamicList<string> names(split(line));
    if (std::find(names.begin(), names.end(), "time") == names.end())
    {
        faults_.append("Line 1 of " + file + " has no column time");
        return;
    }
    scalarList numbers(names.size());
    for (label linei = 2; std::getline(is, line); ++linei)
    {
        const DynamicList<string> values(split(line));
        bool sound = values.size() == names.size();
        for (label i = 0; sound && i < values.size(); ++i)
        {
            sound = isNumber(values[i], numbers[i]);
        }
        if (!sound)
        {
            faults_.append
            (
                "Line " + Foam::name(linei) + " of " + file + " is cut or holds"
                " what is no number"
            );
            continue;
        }
        forAll(values, i)
        {
            columns_(word(names[i])).append(numbers[i]);
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::label Foam::fsi::stepHistory::size() const
{
    return columns_.empty() ? 0 : columns_["time"].size();
}


Foam::scalarField Foam::fsi::stepHistory::column(const word& name) const
{
    const auto* values = findIn(columns_, name);
    if (!values || values->size() != size())
    {
        FatalErrorInFunction
            << "The files global.csv in " << folder_ << " have "
            << (values ? "not all a column " : "no column ") << name
            << "; there are " << flatOutput(columns_.sortedToc())
            << exit(FatalError);
    }
    return scalarField(*values);
}


// ************************************************************************* //
