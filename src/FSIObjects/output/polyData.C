// SPDX-License-Identifier: GPL-3.0-or-later

#include "polyData.H"
#include "foamVtkOutput.H"
#include "foamVtkOutputOptions.H"
#include "OSspecific.H"

#include <fstream>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- Write a named array of labels
static void writeArray
(
    vtk::formatter& format,
    const word& name,
    const labelUList& values
)
{
    format.beginDataArray<label>(name);
    format.writeSize(vtk::sizeofData<label>(values.size()));
    vtk::writeList(format, values);
    format.flush();
    format.endDataArray();
}


//- Write a named array of scalars or vectors in single precision
template<class Type>
static void writeArray
(
    vtk::formatter& format,
    const word& name,
    const UList<Type>& values
)
{
    constexpr direction nComponents = pTraits<Type>::nComponents;
    format.beginDataArray<float, nComponents>(name);
    format.writeSize(vtk::sizeofData<float, nComponents>(values.size()));
    vtk::writeList(format, values);
    format.flush();
    format.endDataArray();
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::polyData::checkSizes() const
{
    const auto check = [](const word& name, const label size, const label n)
    {
        if (size != n)
        {
            FatalErrorInFunction
                << "Data " << name << " has " << size << " values, not " << n
                << exit(FatalError);
        }
    };

    for (const auto& data : cellLabels_)
    {
        check(data.first, data.second.size(), cells.size());
    }
    for (const auto& data : cellScalars_)
    {
        check(data.first, data.second.size(), cells.size());
    }
    for (const auto& data : pointVectors_)
    {
        check(data.first, data.second.size(), points.size());
    }
}


void Foam::fsi::polyData::writeCells(vtk::formatter& format) const
{
    labelList offsets(cells.size());
    label n = 0;
    forAll(cells, celli)
    {
        n += cells[celli].size();
        offsets[celli] = n;
    }

    labelList connectivity(n);
    n = 0;
    for (const labelList& cell : cells)
    {
        for (const label pointi : cell)
        {
            connectivity[n++] = pointi;
        }
    }

    const vtk::fileTag tag =
        kind_ == POLYGONS ? vtk::fileTag::POLYS : vtk::fileTag::LINES;
    format.tag(tag);
    writeArray(format, "connectivity", connectivity);
    writeArray(format, "offsets", offsets);
    format.endTag(tag);
}


void Foam::fsi::polyData::writePiece(vtk::formatter& format) const
{
    format.tag
    (
        vtk::fileTag::PIECE,
        vtk::fileAttr::NUMBER_OF_POINTS, points.size(),
        kind_ == POLYGONS
      ? vtk::fileAttr::NUMBER_OF_POLYS
      : vtk::fileAttr::NUMBER_OF_LINES,
        cells.size()
    );

    format.tag(vtk::fileTag::POINTS);
    writeArray<point>(format, "Points", points);
    format.endTag(vtk::fileTag::POINTS);

    writeCells(format);

    format.beginCellData();
    for (const auto& data : cellLabels_)
    {
        writeArray(format, data.first, data.second);
    }
    for (const auto& data : cellScalars_)
    {
        writeArray<scalar>(format, data.first, data.second);
    }
    format.endCellData();

    format.beginPointData();
    for (const auto& data : pointVectors_)
    {
        writeArray<vector>(format, data.first, data.second);
    }
    format.endPointData();
    format.endPiece();
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::polyData::polyData(const cellKind kind)
:
    kind_(kind)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::polyData::write
(
    const fileName& file,
    const scalar time,
    const bool binary
) const
{
    checkSizes();
    mkDir(file.path());

    std::ofstream os(file);
    autoPtr<vtk::formatter> format = vtk::newFormatter
    (
        os,
        binary ? vtk::formatType::INLINE_BASE64 : vtk::formatType::INLINE_ASCII,
        9u
    );

    format().xmlHeader();
    format().beginVTKFile<vtk::fileTag::POLY_DATA>();
    format().beginFieldData();
    format().writeTimeValue(time);
    format().endFieldData();
    writePiece(format());
    format().endTag(vtk::fileTag::POLY_DATA);
    format().endVTKFile();

    os.close();
    if (!os)
    {
        FatalErrorInFunction
            << "Cannot write " << file << exit(FatalError);
    }
}


// ************************************************************************* //
