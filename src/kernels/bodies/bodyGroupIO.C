// SPDX-License-Identifier: GPL-3.0-or-later

#include "bodyGroup.H"

#include <algorithm>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- Write a matrix, column by column
static void writeMatrix
(
    Ostream& os,
    const word& key,
    const Eigen::MatrixXd& matrix
)
{
    List<scalar> values(matrix.size());
    std::copy_n(matrix.data(), values.size(), values.begin());
    // With its type, so that a dictionary can read it from a binary stream
    values.writeEntry(key, os);
}


//- Read a matrix of the size it has; FatalIOError if the entry has another
static void readMatrix
(
    const dictionary& dict,
    const word& key,
    Eigen::MatrixXd& matrix
)
{
    const List<scalar> values(dict.get<List<scalar>>(key));
    if (values.size() != matrix.size())
    {
        FatalIOErrorInFunction(dict)
            << "Entry '" << key << "' in dictionary " << dict.name() << " has "
            << values.size() << " values but must have "
            << label(matrix.size()) << exit(FatalIOError);
    }
    std::copy_n(values.cbegin(), values.size(), matrix.data());
}


//- Write the node labels of the triangles of all copies
static void writeTriangles
(
    Ostream& os,
    const List<List<bodyElement>>& triangles
)
{
    DynamicList<label> labels;
    for (const List<bodyElement>& copy : triangles)
    {
        for (const bodyElement& triangle : copy)
        {
            for (label i = 0; i < 3; ++i)
            {
                labels.append(triangle[i]);
            }
        }
    }
    labelList(std::move(labels)).writeEntry("triangles", os);
}


//- Read them into lists of the sizes they have
static void readTriangles
(
    const dictionary& dict,
    const label nNodes,
    List<List<bodyElement>>& triangles
)
{
    const labelList labels(dict.get<labelList>("triangles"));
    label next = 0;
    for (List<bodyElement>& copy : triangles)
    {
        for (bodyElement& triangle : copy)
        {
            for (label i = 0; i < 3 && next < labels.size(); ++i)
            {
                triangle[i] = labels[next++];
            }
        }
    }
    const label expected =
        triangles.empty() ? 0 : 3*triangles.size()*triangles[0].size();
    if
    (
        labels.size() != expected
     || (expected && (min(labels) < 0 || max(labels) >= nNodes))
    )
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'triangles' in dictionary " << dict.name() << " has "
            << labels.size() << " values but must have " << expected
            << " labels of nodes" << exit(FatalIOError);
    }
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::bodyGroup::write(Ostream& os) const
{
    const int oldPrecision = os.precision(17);

    os.writeEntry("shape", shape_.name());
    objectIds_.writeEntry("objectIds", os);
    writeMatrix(os, "positions", positions_);
    writeMatrix(os, "velocities", velocities_);
    if (divisible())
    {
        writeMatrix(os, "meanLoad", meanLoad_);
    }
    if (shape_.law().hasState())
    {
        writeMatrix(os, "springStates", springStates_);
    }
    if (shape_.membrane())
    {
        writeTriangles(os, triangles_);
    }

    os.precision(oldPrecision);
}


void Foam::fsi::bodyGroup::read(const dictionary& dict)
{
    const labelList ids(dict.get<labelList>("objectIds"));
    resize(ids.size());
    objectIds_ = ids;
    readMatrix(dict, "positions", positions_);
    readMatrix(dict, "velocities", velocities_);
    meanLoad_.setZero();
    if (dict.found("meanLoad"))
    {
        readMatrix(dict, "meanLoad", meanLoad_);
    }
    if (shape_.law().hasState())
    {
        readMatrix(dict, "springStates", springStates_);
    }
    if (shape_.membrane())
    {
        readTriangles(dict, shape_.nNodes(), triangles_);
    }
}


void Foam::fsi::bodyGroup::read(Istream& is)
{
    read(dictionary(is));
}


// ************************************************************************* //
