// SPDX-License-Identifier: GPL-3.0-or-later

#include "vtkXml.H"

#include <cstring>
#include <limits>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- Convert to single precision; clamp values outside its range
static float single(const scalar value)
{
    typedef std::numeric_limits<float> range;
    return
        value >= range::max() ? range::max()
      : value <= range::lowest() ? range::lowest()
      : float(value);
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::vtkXml::indent()
{
    os_ << std::string(2*open_.size(), ' ');
}


void Foam::fsi::vtkXml::beginArray
(
    const char* kind,
    const std::string& name,
    const std::string& more
)
{
    begin
    (
        "DataArray",
        std::string("type='") + kind + "' Name='" + name + "'" + more
      + " format='binary'"
    );
}


template<class Number>
void Foam::fsi::vtkXml::writeNumbers(const std::vector<Number>& numbers)
{
    writeBase64
    (
        reinterpret_cast<const char*>(numbers.data()),
        numbers.size()*sizeof(Number)
    );
}


void Foam::fsi::vtkXml::writeBase64
(
    const char* bytes,
    const std::uint64_t size
)
{
    static const char digits[] =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

    std::vector<unsigned char> all(sizeof(size) + size);
    std::memcpy(all.data(), &size, sizeof(size));
    std::copy(bytes, bytes + size, all.begin() + sizeof(size));

    const std::size_t n = all.size();
    all.resize(3*((n + 2)/3), 0);
    std::string text;
    text.reserve(all.size()/3*4 + 1);
    for (std::size_t i = 0; i < all.size(); i += 3)
    {
        const unsigned bits = all[i] << 16 | all[i + 1] << 8 | all[i + 2];
        for (int shift = 18; shift >= 0; shift -= 6)
        {
            text += digits[(bits >> shift) & 63];
        }
    }
    // Characters that only fill up the last three bytes are shown as =
    std::fill(text.end() - (all.size() - n), text.end(), '=');
    os_ << text << '\n';
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::vtkXml::beginFile(const std::string& type)
{
    const std::uint16_t one = 1;
    const bool little = *reinterpret_cast<const char*>(&one);
    os_ << "<?xml version='1.0'?>\n";
    begin
    (
        "VTKFile",
        "type='" + type + "' version='0.1' byte_order='"
      + (little ? "LittleEndian" : "BigEndian") + "' header_type='UInt64'"
    );
}


void Foam::fsi::vtkXml::begin
(
    const std::string& name,
    const std::string& attributes
)
{
    indent();
    os_ << '<' << name << (attributes.empty() ? "" : " ") << attributes
        << ">\n";
    open_.push_back(name);
}


void Foam::fsi::vtkXml::end()
{
    const std::string name(open_.back());
    open_.pop_back();
    indent();
    os_ << "</" << name << ">\n";
}


void Foam::fsi::vtkXml::array
(
    const std::string& name,
    const labelUList& values
)
{
    beginArray(sizeof(label) == 4 ? "Int32" : "Int64", name, "");
    writeNumbers(std::vector<label>(values.begin(), values.end()));
    end();
}


void Foam::fsi::vtkXml::array
(
    const std::string& name,
    const UList<scalar>& values
)
{
    std::vector<float> numbers;
    numbers.reserve(values.size());
    for (const scalar value : values)
    {
        numbers.push_back(single(value));
    }
    beginArray("Float32", name, "");
    writeNumbers(numbers);
    end();
}


void Foam::fsi::vtkXml::array
(
    const std::string& name,
    const UList<vector>& values
)
{
    std::vector<float> numbers;
    numbers.reserve(3*values.size());
    for (const vector& value : values)
    {
        for (direction d = 0; d < 3; ++d)
        {
            numbers.push_back(single(value[d]));
        }
    }
    beginArray("Float32", name, " NumberOfComponents='3'");
    writeNumbers(numbers);
    end();
}


void Foam::fsi::vtkXml::array
(
    const std::string& name,
    const UList<word>& values
)
{
    // Characters, with a zero behind each word
    std::string text;
    for (const word& value : values)
    {
        text += value + '\0';
    }
    begin
    (
        "Array",
        "type='String' Name='" + name + "' NumberOfTuples='"
      + std::to_string(values.size()) + "' format='binary'"
    );
    writeBase64(text.data(), text.size());
    end();
}


void Foam::fsi::vtkXml::time(const scalar value)
{
    beginArray("Float32", "TimeValue", " NumberOfTuples='1'");
    writeNumbers(std::vector<float>(1, single(value)));
    end();
}


// ************************************************************************* //
