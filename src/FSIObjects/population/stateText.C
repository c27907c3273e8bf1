// SPDX-License-Identifier: GPL-3.0-or-later

#include "stateText.H"
#include "noTraps.H"

#include <cctype>
#include <cstdlib>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- Is a place in a text the end of the type of a list, as in List<vector>?
static bool endsListType(const std::string& text, const std::size_t place)
{
    const std::size_t end = text.find('>', text.rfind("List<", place));
    return text.find_first_not_of('>', end) == place + 1;
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

std::istringstream Foam::fsi::entryAt
(
    const std::string& text,
    std::size_t place
)
{
    std::size_t start = text.rfind('\n', place);
    while
    (
        start != std::string::npos && start > 0
     && !std::isalpha(static_cast<unsigned char>(text[start + 1]))
    )
    {
        start = text.rfind('\n', start - 1);
    }
    const std::size_t end = text.find('\n', start + 1);
    return std::istringstream(text.substr(start + 1, end - start - 1));
}


Foam::word Foam::fsi::oversized(const std::string& text)
{
    static const char* const blanks = " \t\r\n";
    const noTraps untrapped;
    const bool binary = text.find("binary") < text.find('}');
    std::size_t at = text.find_first_of("({");
    for (; at != std::string::npos; at = text.find_first_of("({", at + 1))
    {
        // A number in a list of lists is a value, and among the bytes of
        // numbers only what follows the type of a list counts
        const std::size_t end = text.find_last_not_of(blanks, at - 1);
        const std::size_t before = text.find_last_of(" \t\r\n(){};>", end);
        const std::size_t type = text.find_last_not_of(blanks, before);
        if (at == 0 || before >= end || type > before)
        {
            continue;
        }
        const bool negative = text[before + 1] == '-';
        const std::size_t digits = before + 1 + negative;
        const scalar n = std::strtod(text.c_str() + digits, nullptr);
        const scalar most = (text[at] == '{' ? 1000.0 : 1.0)*text.size();
        if
        (
            digits <= end && text.find_first_not_of("0123456789", digits) > end
         && (n > most || negative) && text[type] != '(' && text[type] != ')'
         && (!binary || endsListType(text, type))
        )
        {
            std::string key;
            entryAt(text, before) >> key;
            return word(key);
        }
    }
    return word();
}


// ************************************************************************* //
