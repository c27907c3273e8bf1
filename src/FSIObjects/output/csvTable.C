// SPDX-License-Identifier: GPL-3.0-or-later

#include "csvTable.H"
#include "OSspecific.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- The name of a file, after its folder is made
static const fileName& inNewFolder(const fileName& file)
{
    mkDir(file.path());
    return file;
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::csvTable::csvTable(const fileName& file, const wordList& columns)
:
    os_(inNewFolder(file)),
    nColumns_(columns.size())
{
    if (!os_.good())
    {
        FatalErrorInFunction
            << "Cannot write " << file << exit(FatalError);
    }

    rowWriter header(*this);
    for (const word& column : columns)
    {
        header << column;
    }
}


Foam::fsi::csvTable::rowWriter::rowWriter(csvTable& table)
:
    table_(table),
    nValues_(0)
{}


Foam::fsi::csvTable::rowWriter::~rowWriter() noexcept(false)
{
    table_.os_.stdStream() << std::endl;
    if (nValues_ != table_.nColumns_)
    {
        FatalErrorInFunction
            << "A row of " << table_.os_.name() << " has " << nValues_
            << " values for " << table_.nColumns_ << " columns"
            << exit(FatalError);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

std::ostream& Foam::fsi::csvTable::rowWriter::next()
{
    std::ostream& os = table_.os_.stdStream();
    if (nValues_++)
    {
        os << ',';
    }
    return os;
}


Foam::fsi::csvTable::rowWriter&
Foam::fsi::csvTable::rowWriter::operator<<(const scalar value)
{
    std::ostream& os = next();
    if (value >= GREAT)
    {
        os << "inf";
    }
    else
    {
        const std::streamsize previous = os.precision(12);
        os << value;
        os.precision(previous);
    }
    return *this;
}


Foam::fsi::csvTable::rowWriter&
Foam::fsi::csvTable::rowWriter::operator<<(const label value)
{
    next() << value;
    return *this;
}


Foam::fsi::csvTable::rowWriter&
Foam::fsi::csvTable::rowWriter::operator<<(const word& value)
{
    next() << value;
    return *this;
}


Foam::fsi::csvTable::rowWriter&
Foam::fsi::csvTable::rowWriter::operator<<(const vector& value)
{
    return *this << value.x() << value.y() << value.z();
}


// ************************************************************************* //
