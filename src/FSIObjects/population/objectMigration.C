// SPDX-License-Identifier: GPL-3.0-or-later

#include "objectMigration.H"
#include "SubField.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::objectMigration::pack
(
    const label objecti,
    DynamicList<scalar>& numbers
) const
{
    copyValues values;
    label groupi = objects_.objectGroup(objecti);
    values.number(groupi);
    objects_.groups()[groupi].exchange(objects_.objectCopy(objecti), values);
    for (const vectorField* field : nodal_)
    {
        for (label i = start_[objecti]; i < start_[objecti + 1]; ++i)
        {
            vector v((*field)[i]);
            values.vectorOf(v);
        }
    }
    numbers.append(values.values());
}


void Foam::fsi::objectMigration::unpack(copyValues& values)
{
    label groupi = 0;
    values.number(groupi);
    bodyGroup& group = objects_.groups()[groupi];
    const label copyi = group.size();
    group.resize(copyi + 1);
    group.exchange(copyi, values);
    for (Map<vectorField>& fields : came_)
    {
        vectorField field(group.shape().nBoundaryNodes());
        for (vector& v : field)
        {
            values.vectorOf(v);
        }
        fields.insert(group.objectIds()[copyi], field);
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::objectMigration::objectMigration
(
    heldObjects& objects,
    const std::vector<vectorField*>& nodal,
    const labelListList& leaving
)
:
    objects_(objects),
    nodal_(nodal),
    start_(objects.surfaces().pointStart()),
    came_(nodal.size())
{
    for (label objecti = 0; objecti < objects.size(); ++objecti)
    {
        last_.insert(objects.objectId(objecti), objecti);
    }
    List<DynamicList<scalar>> sent(leaving.size());
    forAll(leaving, ranki)
    {
        for (const label objecti : leaving[ranki])
        {
            pack(objecti, sent[ranki]);
            left_.append(objecti);
        }
    }
    received_ = objects.ranks().swap(sent);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::fsi::objectMigration::append()
{
    bool any = left_.size();
    for (const scalarList& ofRank : received_)
    {
        copyValues values(ofRank);
        while (values.more())
        {
            unpack(values);
            any = true;
        }
    }
    for (bodyGroup& group : objects_.groups())
    {
        group.sort();
    }
    return any;
}


void Foam::fsi::objectMigration::follow() const
{
    const labelList& start = objects_.surfaces().pointStart();
    for (std::size_t fieldi = 0; fieldi < nodal_.size(); ++fieldi)
    {
        const vectorField before(*nodal_[fieldi]);
        vectorField& field = *nodal_[fieldi];
        field.setSize(objects_.layout().nSurface());
        field = Zero;
        for (label objecti = 0; objecti < objects_.size(); ++objecti)
        {
            const label id = objects_.objectId(objecti);
            const label n = start[objecti + 1] - start[objecti];
            const vectorField* given = findIn(came_[fieldi], id);
            SubField<vector>(field, n, start[objecti]) =
                given
              ? SubField<vector>(*given, n)
              : SubField<vector>(before, n, start_[*findIn(last_, id)]);
        }
    }
}


// ************************************************************************* //
