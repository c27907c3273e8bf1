// SPDX-License-Identifier: GPL-3.0-or-later

#include "shearMatrix.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::shearMatrix::shearMatrix
(
    const strainDomains& domains,
    const labelUList& rowOf
)
{
    matrixEntries laplacian, curl;
    domains.addLaplacian(1, laplacian);
    if (domains.nDims() == 2)
    {
        domains.addCurl(curl);
    }

    // Both have the same places, in the same order
    typedef Eigen::SparseMatrix<double, Eigen::RowMajor> matrix;
    const auto assembled = [&](matrixEntries& entries)
    {
        for (auto& entry : entries)
        {
            entry = matrixEntries::value_type
            (
                rowOf[entry.row()],
                rowOf[entry.col()],
                entry.value()
            );
        }
        matrix result(rowOf.size(), rowOf.size());
        result.setFromTriplets(entries.begin(), entries.end());
        return result;
    };
    const matrix L(assembled(laplacian)), C(assembled(curl));

    DynamicList<label> start(1, label(0)), columns;
    DynamicList<scalar> values[2];
    for (label row = 0; row < L.outerSize(); ++row)
    {
        const int* rows = L.outerIndexPtr();
        for (int e = rows[row]; e < rows[row + 1]; ++e)
        {
            if (L.innerIndexPtr()[e] != row)
            {
                columns.append(L.innerIndexPtr()[e]);
                values[0].append(L.valuePtr()[e]);
                if (C.nonZeros())
                {
                    values[1].append(C.valuePtr()[e]);
                }
            }
        }
        start.append(columns.size());
    }
    start_ = start;
    column_ = columns;
    laplacian_ = values[0];
    curl_ = values[1];
}


// ************************************************************************* //
