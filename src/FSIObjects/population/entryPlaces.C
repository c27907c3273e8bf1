// SPDX-License-Identifier: GPL-3.0-or-later

#include "entryPlaces.H"

#include <algorithm>
#include <cctype>
#include <cstdlib>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- Bytes of a value as the header's entry arch tells (label=32;), or what they
//  are here
static std::size_t bytesOf
(
    const std::string& text,
    const std::string& type,
    const std::size_t here
)
{
    const std::size_t found = text.find(type + "=");
    return
        found < 2000
      ? std::strtoul(text.c_str() + found + type.size() + 1, nullptr, 10)/8
      : here;
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::entryPlaces::skipTo(const char* end)
{
    const std::size_t found = text_.find(end, at_ + 1);
    const std::size_t next =
        found == std::string::npos
      ? text_.size()
      : found + std::string(end).size();
    line_ += std::count(text_.begin() + at_, text_.begin() + next, '\n');
    at_ = next;
}


void Foam::fsi::entryPlaces::readWord()
{
    const std::size_t start = at_;
    while
    (
        at_ < text_.size()
     && (
            std::isalnum(static_cast<unsigned char>(text_[at_]))
         || std::string("_<>:.+-").find(text_[at_]) != std::string::npos
        )
    )
    {
        ++at_;
    }
    const std::string name(text_.substr(start, at_ - start));
    if (entryStart_)
    {
        keys_.append(word(name));
        lines_.append(line_);
    }
    entryStart_ = false;
    valueSize_ =
        name == "List<scalar>" ? scalarSize_
      : name == "List<label>" ? labelSize_
      : name == "List<vector>" ? 3*scalarSize_
      : 0;
}


void Foam::fsi::entryPlaces::readDigits()
{
    const bool negative = text_[at_ - 1] == '-' && valueSize_;
    std::size_t value = 0;
    while
    (
        at_ < text_.size()
     && std::isdigit(static_cast<unsigned char>(text_[at_]))
    )
    {
        value = std::min<std::size_t>(value, 1e15);
        value = 10*value + (text_[at_++] - '0');
    }
    std::size_t next = at_;
    while
    (
        next < text_.size()
     && std::isspace(static_cast<unsigned char>(text_[next]))
    )
    {
        ++next;
    }
    const char bracket = next < text_.size() ? text_[next] : ' ';

    // A list of equal values may have more of them than bytes
    const std::size_t limit =
        negative ? 0
      : bracket == '(' ? text_.size()
      : bracket == '{' ? 1000*text_.size()
      : value;
    if (value > limit && oversized_.empty() && keys_.size())
    {
        oversized_ = keys_.last();
    }
    if (binary_ && bracket == '(' && valueSize_ && value <= limit)
    {
        line_ += std::count(text_.begin() + at_, text_.begin() + next, '\n');
        at_ = std::min(next + 1 + valueSize_*value, text_.size());
    }
    valueSize_ = 0;
    entryStart_ = false;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::entryPlaces::entryPlaces(const std::string& text)
:
    text_(text),
    binary_(false),
    scalarSize_(bytesOf(text_, "scalar", sizeof(scalar))),
    labelSize_(bytesOf(text_, "label", sizeof(label)))
{
    const std::size_t format = text_.find("format");
    binary_ =
        format < 2000
     && text_.substr(format, 40).find("binary") != std::string::npos;

    while (at_ < text_.size())
    {
        const unsigned char c = text_[at_];
        if (text_.compare(at_, 2, "//") == 0)
        {
            skipTo("\n");
        }
        else if (text_.compare(at_, 2, "/*") == 0)
        {
            skipTo("*/");
        }
        else if (c == '"')
        {
            skipTo("\"");
        }
        else if (std::isalpha(c) || c == '_')
        {
            readWord();
        }
        else if (std::isdigit(c))
        {
            readDigits();
        }
        else
        {
            line_ += c == '\n';
            entryStart_ =
                c == ';' || c == '{' || c == '}'
             || (entryStart_ && std::isspace(c));
            ++at_;
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::word Foam::fsi::entryPlaces::entryAt(const label line) const
{
    word found(keys_.empty() ? word() : keys_.first());
    forAll(keys_, i)
    {
        if (lines_[i] <= line)
        {
            found = keys_[i];
        }
    }
    return found;
}


// ************************************************************************* //
