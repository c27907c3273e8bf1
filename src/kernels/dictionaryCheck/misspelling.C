// SPDX-License-Identifier: GPL-3.0-or-later

#include "misspelling.H"

#include <algorithm>
#include <cctype>
#include <vector>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- Least number of letters to add, remove, change or swap with a neighbour
static label distance(const std::string& a, const std::string& b)
{
    const label n = a.size(), m = b.size();
    std::vector<std::vector<label>> d(n + 1, std::vector<label>(m + 1));
    for (label i = 0; i <= n; ++i)
    {
        for (label j = 0; j <= m; ++j)
        {
            if (i == 0 || j == 0)
            {
                d[i][j] = i + j;
                continue;
            }
            const label other = std::tolower(a[i-1]) != std::tolower(b[j-1]);
            d[i][j] = std::min
            (
                {d[i-1][j] + 1, d[i][j-1] + 1, d[i-1][j-1] + other}
            );
            if (i > 1 && j > 1 && a[i-1] == b[j-2] && a[i-2] == b[j-1])
            {
                d[i][j] = std::min(d[i][j], d[i-2][j-2] + 1);
            }
        }
    }
    return d[n][m];
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::word Foam::fsi::meant
(
    const word& name,
    const wordList& known
)
{
    word nearest;
    label least = labelMax;
    for (const word& key : known)
    {
        const label d = distance(name, key);
        if (d < least && d <= min(label(key.size() + 2)/4, label(3)))
        {
            least = d;
            nearest = key;
        }
    }
    return nearest;
}


// ************************************************************************* //
