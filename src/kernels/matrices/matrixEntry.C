// SPDX-License-Identifier: GPL-3.0-or-later

#include "matrixEntry.H"
#include "errorOf.H"
#include "openfoamVersion.H"

#include <algorithm>

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::fsi::writeMatrix
(
    Ostream& os,
    const word& key,
    const Eigen::MatrixXd& matrix
)
{
    const UList<scalar> values
    (
        const_cast<scalar*>(matrix.data()), matrix.size()
    );
    // With its type, so that a dictionary can read it from a binary stream
    putList(os, key, values);
}


void Foam::fsi::readMatrix
(
    const dictionary& dict,
    const word& key,
    Eigen::MatrixXd& matrix
)
{
    const List<scalar> values(readEntry<List<scalar>>(dict, key));
    if (values.size() != matrix.size())
    {
        FatalIOErrorInFunction(dict)
            << "Entry '" << key << "' in dictionary " << dict.name() << " has "
            << values.size() << " values but must have "
            << label(matrix.size()) << exit(FatalIOError);
    }
    checkValues(dict, key, values);
    std::copy_n(values.cbegin(), values.size(), matrix.data());
}


// ************************************************************************* //
