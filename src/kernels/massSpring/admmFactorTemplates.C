// SPDX-License-Identifier: GPL-3.0-or-later

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

template<int width>
void Foam::fsi::admmFactor::solveRows(scalar* __restrict__ rows) const
{
    const label n = size();

    // The sum of a row stays in registers, as the width is known
    scalar sum[width];

    for (label i = 0; i < n; ++i)
    {
        scalar* __restrict__ row = rows + label(width)*i;
        for (int k = 0; k < width; ++k) sum[k] = row[k];

        for (label e = rowStart_[i]; e < rowStart_[i + 1]; ++e)
        {
            const scalar value = rowValue_[e];
            const scalar* other = rows + label(width)*rowColumn_[e];
            for (int k = 0; k < width; ++k) sum[k] -= value*other[k];
        }
        const scalar inverse = inverseDiagonal_[i];
        for (int k = 0; k < width; ++k) row[k] = inverse*sum[k];
    }

    for (label i = n - 1; i >= 0; --i)
    {
        scalar* __restrict__ row = rows + label(width)*i;
        for (int k = 0; k < width; ++k) sum[k] = row[k];

        for (label e = columnStart_[i]; e < columnStart_[i + 1]; ++e)
        {
            const scalar value = columnValue_[e];
            const scalar* other = rows + label(width)*columnRow_[e];
            for (int k = 0; k < width; ++k) sum[k] -= value*other[k];
        }
        const scalar inverse = inverseDiagonal_[i];
        for (int k = 0; k < width; ++k) row[k] = inverse*sum[k];
    }
}


// ************************************************************************* //
