// SPDX-License-Identifier: GPL-3.0-or-later

#include "contentSum.H"
#include "Hasher.H"

#include <algorithm>
#include <sstream>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::contentSum::add(const char* text, std::streamsize n)
{
    while (n > 0)
    {
        const std::streamsize part =
            std::min(n, std::streamsize(sizeof(block_)) - inBlock_);
        std::copy_n(text, part, block_ + inBlock_);
        inBlock_ += part;
        text += part;
        n -= part;
        if (inBlock_ == std::streamsize(sizeof(block_)))
        {
            sum_ = Hasher(block_, sizeof(block_), sum_);
            inBlock_ = 0;
        }
    }
}


// * * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * //

Foam::fsi::contentSum::int_type Foam::fsi::contentSum::overflow(int_type c)
{
    if (traits_type::eq_int_type(c, traits_type::eof()))
    {
        return traits_type::not_eof(c);
    }
    const char character = traits_type::to_char_type(c);
    add(&character, 1);
    return target_.sputc(character);
}


std::streamsize Foam::fsi::contentSum::xsputn
(
    const char* text,
    std::streamsize n
)
{
    add(text, n);
    return target_.sputn(text, n);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::contentSum::contentSum(std::streambuf& target)
:
    target_(target),
    inBlock_(0),
    sum_(0)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::word Foam::fsi::contentSum::value() const
{
    // With a letter in front, so that it is a word in a file
    std::ostringstream os;
    os << '_' << std::hex << Hasher(block_, inBlock_, sum_);
    return word(os.str());
}


Foam::word Foam::fsi::contentSum::of
(
    const std::string& text,
    const std::size_t n
)
{
    std::stringbuf none;
    contentSum sum(none);
    sum.add(text.data(), n);
    return sum.value();
}


// ************************************************************************* //
