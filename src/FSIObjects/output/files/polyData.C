// SPDX-License-Identifier: GPL-3.0-or-later

#include "polyData.H"
#include "OSspecific.H"
#include "vtkXml.H"

#include <fstream>

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
    for (const auto& data : pointScalars_)
    {
        check(data.first, data.second.size(), points.size());
    }
    for (const auto& data : pointVectors_)
    {
        check(data.first, data.second.size(), points.size());
    }
}


void Foam::fsi::polyData::writeCells(vtkXml& xml) const
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

    xml.begin(kind_ == POLYGONS ? "Polys" : "Lines");
    xml.array("connectivity", connectivity);
    xml.array("offsets", offsets);
    xml.end();
}


void Foam::fsi::polyData::writePiece(vtkXml& xml) const
{
    xml.begin
    (
        "Piece",
        "NumberOfPoints='" + std::to_string(points.size())
      + (kind_ == POLYGONS ? "' NumberOfPolys='" : "' NumberOfLines='")
      + std::to_string(cells.size()) + "'"
    );

    xml.begin("Points");
    xml.array("Points", points);
    xml.end();

    writeCells(xml);

    xml.begin("CellData");
    for (const auto& data : cellLabels_)
    {
        xml.array(data.first, data.second);
    }
    for (const auto& data : cellScalars_)
    {
        xml.array(data.first, data.second);
    }
    xml.end();

    xml.begin("PointData");
    for (const auto& data : pointScalars_)
    {
        xml.array(data.first, data.second);
    }
    for (const auto& data : pointVectors_)
    {
        xml.array(data.first, data.second);
    }
    xml.end();
    xml.end();
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
    const scalar time
) const
{
    checkSizes();
    mkDir(file.path());

    std::ofstream os(file);
    vtkXml xml(os);
    xml.beginFile("PolyData");
    xml.begin("PolyData");
    xml.begin("FieldData");
    xml.time(time);
    for (const auto& data : words_)
    {
        xml.array(data.first, data.second);
    }
    xml.end();
    writePiece(xml);
    xml.end();
    xml.end();

    os.close();
    if (!os)
    {
        FatalErrorInFunction
            << "Cannot write " << file << exit(FatalError);
    }
}


// ************************************************************************* //
