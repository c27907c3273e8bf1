// SPDX-License-Identifier: GPL-3.0-or-later

#include "faceLattice.H"
#include "openfoamVersion.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::faceLattice::addLines
(
    const label facei,
    const label celli,
    FixedList<Map<label>, 3>& lineAt
)
{
    const direction d = grid_.faceDirection(facei);
    const bool up = grid_.faceAlong(facei);
    const label inward = up ? -lattice_.stride(d) : lattice_.stride(d);
    const auto add = [&](const direction component, const label at)
    {
        const auto known = lineAt[component].find(at);
        if (known != lineAt[component].end())
        {
            lines_[*known].faces[1] = facei;
            return;
        }
        line l;
        l.component = component;
        l.across = component == d;
        const label first = l.across ? at + inward : at;
        l.inside[0] = at;
        l.inside[1] = at + inward;
        l.beyond[0] = l.across ? at - inward : first - inward;
        l.beyond[1] = l.beyond[0] - inward;
        l.faces[0] = facei;
        l.faces[1] = -1;
        lineAt[component].insert(at, lines_.size());
        lines_.append(l);
    };
    add(d, side(celli, d, up));
    for (direction t = 0; t < lattice_.nDims; ++t)
    {
        if (t != d)
        {
            add(t, side(celli, t, false));
            add(t, side(celli, t, true));
        }
    }
}


void Foam::fsi::faceLattice::setLines()
{
    // The lines of each side on their own: in a corner they begin at the same
    // face
    const fvMesh& mesh = grid_.mesh();
    for (label side = 0; side < 6; ++side)
    {
        FixedList<Map<label>, 3> lineAt;
        for (const polyPatch& patch : mesh.boundaryMesh())
        {
            if (patch.coupled() || isA<emptyPolyPatch>(patch))
            {
                continue;
            }
            forAll(patch, i)
            {
                const label facei = patch.start() + i;
                if
                (
                    2*grid_.faceDirection(facei)
                  + label(grid_.faceAlong(facei))
                 == side
                )
                {
                    addLines(facei, patch.faceCells()[i], lineAt);
                }
            }
        }
    }

    FixedList<boolList, 3> mine(boolList(lattice_.size(), false));
    grid_.forFaces([&](const label facei)
    {
        if (mine_[facei])
        {
            mine[grid_.faceDirection(facei)][place_[facei]] = true;
        }
    });
    for (line& l : lines_)
    {
        l.mine = mine[l.component][l.inside[0]];
    }
}


Foam::scalar Foam::fsi::faceLattice::sideVelocity
(
    const line& l,
    const volVectorField& U,
    bool& given
) const
{
    scalar sum = 0;
    label n = 0;
    given = true;
    for (const label facei : l.faces)
    {
        if (facei >= 0)
        {
            const label patchi = U.mesh().boundaryMesh().whichPatch(facei);
            const fvPatchVectorField& pU = U.boundaryField()[patchi];
            sum += pU[facei - pU.patch().start()][l.component];
            given = given && pU.fixesValue();
            ++n;
        }
    }
    return sum/n;
}


void Foam::fsi::faceLattice::setBeyond
(
    const volVectorField& U,
    faceArrays& u
) const
{
    for (const line& l : lines_)
    {
        if (!l.mine)
        {
            continue;
        }
        scalarField& values = u[l.component];
        if (l.across)
        {
            values[l.beyond[0]] = 2*values[l.inside[0]] - values[l.inside[1]];
            continue;
        }
        bool given;
        const scalar side = sideVelocity(l, U, given);
        for (label i = 0; i < 2; ++i)
        {
            const scalar inside = values[l.inside[i]];
            values[l.beyond[i]] = given ? 2*side - inside : inside;
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::faceLattice::setCells
(
    const volVectorField& U,
    faceArrays& values,
    vectorField& cells
) const
{
    for (const line& l : lines_)
    {
        scalarField& v = values[l.component];
        if (l.across)
        {
            v[l.inside[0]] += 2*v[l.beyond[0]];
            v[l.inside[1]] -= v[l.beyond[0]];
            continue;
        }
        bool given;
        sideVelocity(l, U, given);
        for (label i = 0; i < 2; ++i)
        {
            const scalar beyond = v[l.beyond[i]];
            v[l.inside[i]] += given ? -beyond : beyond;
        }
    }
    cells.setSize(placeOfCell_.size());
    forAll(placeOfCell_, celli)
    {
        cells[celli] = Zero;
        for (direction d = 0; d < lattice_.nDims; ++d)
        {
            cells[celli][d] =
                0.5
               *(
                    values[d][side(celli, d, false)]
                  + values[d][side(celli, d, true)]
                );
        }
    }
}


// ************************************************************************* //
