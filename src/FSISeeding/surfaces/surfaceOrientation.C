// SPDX-License-Identifier: GPL-3.0-or-later

#include "surfaceOrientation.H"

#include <algorithm>
#include <map>
#include <vector>

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::label Foam::fsi::orientSurface(List<surfaceFace>& faces)
{
    std::map<std::pair<label, label>, std::vector<label>> facesOfEdge;
    forAll(faces, facei)
    {
        for (label i = 0; i < 3; ++i)
        {
            const label a = faces[facei][i], b = faces[facei][(i + 1) % 3];
            facesOfEdge[std::minmax(a, b)].push_back(facei);
        }
    }
    const auto runs = [&](const label facei, const label a, const label b)
    {
        const surfaceFace& f = faces[facei];
        return
            (f[0] == a && f[1] == b) || (f[1] == a && f[2] == b)
         || (f[2] == a && f[0] == b);
    };

    label nTurned = 0;
    labelList sign(faces.size(), 0);
    forAll(faces, first)
    {
        if (sign[first])
        {
            continue;
        }
        std::vector<label> piece(1, first);
        sign[first] = 1;
        label nAgainst = 0;
        for (std::size_t next = 0; next < piece.size(); ++next)
        {
            const label facei = piece[next];
            for (label i = 0; i < 3; ++i)
            {
                const label a = faces[facei][i];
                const label b = faces[facei][(i + 1) % 3];
                const std::vector<label>& both =
                    facesOfEdge[std::minmax(a, b)];
                const label other =
                    both.size() != 2 ? facei
                  : both[0] == facei ? both[1] : both[0];
                if (!sign[other])
                {
                    sign[other] =
                        runs(other, a, b) ? -sign[facei] : sign[facei];
                    nAgainst += sign[other] < 0;
                    piece.push_back(other);
                }
            }
        }
        const label wrong = 2*nAgainst > label(piece.size()) ? 1 : -1;
        for (const label facei : piece)
        {
            if (sign[facei] == wrong)
            {
                Swap(faces[facei][1], faces[facei][2]);
                ++nTurned;
            }
        }
    }
    return nTurned;
}


// ************************************************************************* //
