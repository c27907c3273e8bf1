// SPDX-License-Identifier: GPL-3.0-or-later

#include "csvTable.H"
#include "diskNote.H"
#include "OSspecific.H"
#include "writtenFiles.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::csvTable::open()
{
    mkDir(file_.path());
    os_.reset(new OFstream(file_));
    if (!os_->good())
    {
        FatalErrorInFunction
            << "Cannot write " << file_ << exit(FatalError);
    }

    rowWriter header(*this);
    for (const word& column : columns_)
    {
        header << column;
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::csvTable::csvTable(const fileName& file, const wordList& columns)
:
    file_(file),
    columns_(columns)
{
    open();
}


Foam::fsi::csvTable::rowWriter::rowWriter(csvTable& table)
:
    table_(table),
    nValues_(0)
{
    if (!isFile(table_.file_, false))
    {
        WarningInFunction
            << "Somebody removed " << table_.file_ << ": it is begun anew,"
            << " without the lines before" << nl << endl;
        table_.open();
    }
}


Foam::fsi::csvTable::rowWriter::~rowWriter() noexcept(false)
{
    std::ostream& os = table_.os_->stdStream();
    os << std::endl;
    if (!os.good())
    {
        const fileName& file = table_.file_;
        FatalErrorInFunction
            << "Cannot write " << file << nl
            << diskNote(file.path()).c_str()
            << writtenFiles::lastTimeNote
               (
                   file.substr(0, file.find("/postProcessing"))
               ).c_str()
            << exit(FatalError);
    }
    if (nValues_ != table_.columns_.size())
    {
        FatalErrorInFunction
            << "A row of " << table_.file_ << " has " << nValues_
            << " values for " << table_.columns_.size() << " columns"
            << exit(FatalError);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

std::ostream& Foam::fsi::csvTable::rowWriter::next()
{
    std::ostream& os = table_.os_->stdStream();
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
