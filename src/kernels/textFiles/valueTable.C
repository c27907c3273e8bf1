// SPDX-License-Identifier: GPL-3.0-or-later

#include "valueTable.H"
#include "openfoamVersion.H"
#include "textLines.H"

#include <stdexcept>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- The character between the values of most lines
static char separatorOf(const std::vector<std::string_view>& lines)
{
    for (const char separator : {';', ',', '\t'})
    {
        std::size_t n = 0;
        for (const std::string_view line : lines)
        {
            n += line.find(separator) != std::string_view::npos;
        }
        if (2*n >= lines.size())
        {
            return separator;
        }
    }
    return ' ';
}


//- Has the line no number? A title between blanks begins with none
static bool isTitle(const std::vector<std::string>& values, const bool blanks)
{
    if (blanks)
    {
        return values[0].find_first_of("+-.0123456789") != 0;
    }
    bool title = true;
    for (const std::string& value : values)
    {
        scalar number = 0;
        title = title && !isDecimal(value, number);
    }
    return title;
}


static wordList namesIn(const std::vector<std::string>& values)
{
    wordList names;
    for (const std::string& value : values)
    {
        names.append(word(value, false));
    }
    return names;
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::valueTable::fail
(
    const label line,
    const std::string& reason
) const
{
    file_.fail(", line " + std::to_string(line) + reason);
}


Foam::fsi::valueTable::row Foam::fsi::valueTable::splitLine
(
    std::string_view line,
    const label number
) const
{
    row result{number, {}};
    if (separator_ == ' ')
    {
        for (const std::string_view word : wordsOf(line))
        {
            result.values.emplace_back(word);
        }
        return result;
    }

    std::string value;
    bool quoted = false;
    for (const char c : line)
    {
        quoted ^= c == '"';
        if (c == separator_ && !quoted)
        {
            result.values.emplace_back(trimmed(value));
            value.clear();
        }
        else if (c != '"')
        {
            value += c;
        }
    }
    if (quoted)
    {
        fail(number, ": a quote is not closed");
    }
    result.values.emplace_back(trimmed(value));
    while (result.values.size() && result.values.back().empty())
    {
        result.values.pop_back();
    }
    return result;
}


void Foam::fsi::valueTable::split(const std::string& text)
{
    textLines lines(text);
    std::vector<std::string_view> filled;
    std::vector<label> numbers;
    while (lines.nextFilled('#'))
    {
        filled.push_back(lines.line());
        numbers.push_back(lines.number());
    }
    separator_ = separatorOf(filled);
    for (std::size_t i = 0; i < filled.size(); ++i)
    {
        rows_.push_back(splitLine(filled[i], numbers[i]));
        if (rows_.back().values.empty())
        {
            rows_.pop_back();
        }
    }
}


void Foam::fsi::valueTable::readHead()
{
    if (rows_.size())
    {
        head_ = rows_[0].line;
        columns_ = namesIn(rows_[0].values);
        rows_.erase(rows_.begin());
    }
}


void Foam::fsi::valueTable::readTitles(const wordList& columns)
{
    std::size_t n = 0;
    wordList names(columns);
    for (; n < rows_.size() && isTitle(rows_[n].values, separator_ == ' '); ++n)
    {
        const wordList title(namesIn(rows_[n].values));
        bool all = true;
        for (const word& column : columns)
        {
            all = all && isIn(title, column);
        }
        names = all ? title : names;
    }
    rows_.erase(rows_.begin(), rows_.begin() + n);

    scalar number = 0;
    if
    (
        rows_.size() > 1 && rows_[0].values.size() == 1
     && rows_[1].values.size() > 1 && isDecimal(rows_[0].values[0], number)
    )
    {
        if (number != rows_.size() - 1)
        {
            fail
            (
                rows_[0].line,
                " says that there are " + rows_[0].values[0]
              + " rows, but there are " + std::to_string(rows_.size() - 1)
            );
        }
        rows_.erase(rows_.begin());
    }
    columns_ = names;
    if (rows_.size())
    {
        // More columns than have a name
        columns_.resize(max(columns_.size(), label(rows_[0].values.size())));
    }
}


void Foam::fsi::valueTable::checkSizes() const
{
    for (label i = 0; i < size(); ++i)
    {
        const label n = rows_[i].values.size();
        if (n != columns_.size())
        {
            const std::string wanted(std::to_string(columns_.size()));
            refuse(i, "", std::to_string(n) + " values, not " + wanted);
        }
        forAll(columns_, j)
        {
            if (rows_[i].values[j].empty())
            {
                refuse(i, columns_[j], "the value is missing");
            }
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::valueTable::valueTable
(
    const caseFile& file,
    const wordList& columns
)
:
    file_(file),
    separator_(' '),
    head_(1)
{
    try
    {
        split(file.text());
    }
    catch (const std::runtime_error& error)
    {
        file.fail(std::string(" ") + error.what());
    }
    columns.empty() ? readHead() : readTitles(columns);
    checkSizes();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::fsi::valueTable::has(const word& column) const
{
    return isIn(columns_, column);
}


const std::string& Foam::fsi::valueTable::text
(
    const label rowi,
    const word& column
) const
{
    return rows_[rowi].values[indexOf(columns_, column)];
}


Foam::scalar Foam::fsi::valueTable::number
(
    const label rowi,
    const word& column
) const
{
    scalar value = 0;
    if (!isDecimal(text(rowi, column), value))
    {
        refuse(rowi, column, quoted(text(rowi, column)) + noNumber);
    }
    return value;
}


void Foam::fsi::valueTable::refuse
(
    const label rowi,
    const std::string& column,
    const std::string& reason
) const
{
    fail
    (
        rows_[rowi].line,
        (column.empty() ? "" : ", column " + column) + ": " + reason
    );
}


void Foam::fsi::valueTable::refuse(const std::string& reason) const
{
    fail(head_, ": " + reason);
}


// ************************************************************************* //
