// SPDX-License-Identifier: GPL-3.0-or-later

#include "textLines.H"
#include "errorOf.H"
#include "noTraps.H"

#include <cerrno>
#include <cstdlib>
#include <limits>
#include <stdexcept>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

static const char* const blanks = " \t\v\f";

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::textLines::textLines(const std::string& text)
:
    text_(text),
    next_(text.compare(0, 3, "\xef\xbb\xbf") == 0 ? 3 : 0),
    number_(0)
{
    const std::size_t zero = text.find('\0');
    if (zero != std::string::npos)
    {
        throw std::runtime_error
        (
            "is no plain text: byte " + std::to_string(zero + 1)
          + " is 0; save it as plain text, UTF-8"
        );
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::fsi::textLines::next()
{
    if (next_ >= text_.size())
    {
        return false;
    }
    const std::size_t end = std::min
    (
        text_.find_first_of("\r\n", next_), text_.size()
    );
    line_ = std::string_view(text_).substr(next_, end - next_);
    const bool two = text_.compare(end, 2, "\r\n") == 0;
    next_ = end + (two ? 2 : 1);
    ++number_;
    return true;
}


bool Foam::fsi::textLines::nextFilled(const char mark)
{
    while (next())
    {
        line_ = trimmed(line_.substr(0, line_.find(mark)));
        if (!line_.empty())
        {
            return true;
        }
    }
    return false;
}


void Foam::fsi::textLines::fail(const std::string& reason) const
{
    throw std::runtime_error
    (
        "line " + std::to_string(number_) + ": " + reason
    );
}


Foam::scalar Foam::fsi::textLines::number(std::string_view word) const
{
    scalar value = 0;
    if (!isDecimal(word, value))
    {
        fail(quoted(word) + noNumber);
    }
    return value;
}


Foam::label Foam::fsi::textLines::wholeNumber(std::string_view word) const
{
    const std::string text(word);
    char* end = nullptr;
    errno = 0;
    const long long value = std::strtoll(text.c_str(), &end, 10);
    if
    (
        text.empty() || *end || errno
     || std::abs(value) > std::numeric_limits<label>::max()
    )
    {
        fail(quoted(word) + " is no whole number, or too large");
    }
    return label(value);
}


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

std::string_view Foam::fsi::trimmed(std::string_view text)
{
    const std::size_t start = text.find_first_not_of(blanks);
    if (start == std::string_view::npos)
    {
        return std::string_view();
    }
    return text.substr(start, text.find_last_not_of(blanks) + 1 - start);
}


std::vector<std::string_view> Foam::fsi::wordsOf(std::string_view line)
{
    std::vector<std::string_view> words;
    for (std::size_t end = 0; end < line.size();)
    {
        const std::size_t start = line.find_first_not_of(blanks, end);
        if (start == std::string_view::npos)
        {
            break;
        }
        end = std::min(line.find_first_of(blanks, start), line.size());
        words.push_back(line.substr(start, end - start));
    }
    return words;
}


std::string Foam::fsi::quoted(std::string_view word)
{
    std::string text(word.substr(0, 30));
    for (char& c : text)
    {
        if (static_cast<unsigned char>(c) < ' ' || c == '\x7f')
        {
            c = '?';
        }
    }
    return "'" + text + (word.size() > 30 ? "...'" : "'");
}


bool Foam::fsi::isDecimal(std::string_view word, scalar& value)
{
    char text[64];
    if
    (
        word.empty() || word.size() >= sizeof(text)
     || word.find_first_not_of("+-.0123456789eE") != std::string_view::npos
    )
    {
        return false;
    }
    text[word.copy(text, word.size())] = '\0';
    // 1e400 raises a signal otherwise
    const noTraps untrapped;
    char* end = nullptr;
    value = std::strtod(text, &end);
    return *end == '\0' && isUsable(value);
}


// ************************************************************************* //
